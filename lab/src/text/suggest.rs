//! Suggestion of the nearest known word.

/// The least likeness, from 0 to 1, at which one word is suggested for another.
const ALIKE: f64 = 0.5;

/// Likeness of a key and its last parts, which somebody wrote without the tables around them.
const END: f64 = 0.99;

/// The known word most like this one, if any is like enough; none where another is as like.
pub(crate) fn nearest<'a>(word: &str, known: &[&'a str]) -> Option<&'a str> {
    // A word of a million letters is no misspelling, and comparing it takes long.
    if word.len() > 80 {
        return None;
    }
    let word = plain(word);
    let alike = |candidate: &&'a str| (likeness(&word, &plain(candidate)), *candidate);
    let near = || known.iter().map(alike).filter(|(likeness, _)| *likeness >= ALIKE);
    let (most, nearest) = near().max_by(|(one, _), (other, _)| one.total_cmp(other))?;
    let is_twin = |(likeness, candidate)| likeness == most && candidate != nearest;
    (!near().any(is_twin)).then_some(nearest)
}

/// The word without the differences that people mix up: case, and the separator between the parts of a word.
fn plain(word: &str) -> String {
    word.to_ascii_lowercase().replace(['-', ' '], "_")
}

fn likeness(word: &str, candidate: &str) -> f64 {
    let alike = strsim::normalized_damerau_levenshtein;
    // Keys of other names share many letters of their tables, and mean other things.
    let [name, other] = [word, candidate].map(|key| key.rsplit('.').next().unwrap_or(key));
    let is_named_so = alike(name, other) >= ALIKE;
    let likeness = if is_named_so { alike(word, candidate) } else { 0.0 };
    let contained = word.len() >= 3 && (candidate.contains(word) || word.contains(candidate));
    let end =
        word.contains('.') && candidate.strip_suffix(word).is_some_and(|it| it.ends_with('.'));
    match (end, contained) {
        (true, _) => likeness.max(END),
        (_, true) => likeness.max(ALIKE),
        _ => likeness,
    }
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn a_key_without_its_outer_table_is_known_by_its_end() {
        let keys = [
            "environment_rate",
            "operator.stiffness",
            "environment.wall.stiffness",
            "environment.wall.damping",
        ];
        assert_eq!(nearest("wall.stiffness", &keys), Some("environment.wall.stiffness"));
        assert_eq!(nearest("stifness", &["mass", "stiffness"]), Some("stiffness"));
        assert_eq!(nearest("qwertz", &keys), None);
        assert_eq!(nearest("environment.sphere.radius", &keys), None);
        assert_eq!(nearest("enviroment.wall.damp", &keys), Some("environment.wall.damping"));
    }
}
