//! Words that fit their place: sentences folded to a terminal's width, and names in one cell.

use textwrap::core::display_width;
use textwrap::{Options, WordSplitter};

/// The widest line, in columns.
const WIDTH: usize = 98;

/// `text` folded between words: the first line behind `label`, the others behind as many blanks.
pub(crate) fn folded(label: &str, text: &str) -> String {
    let blanks = " ".repeat(display_width(label));
    let options = Options::new(WIDTH)
        .initial_indent(label)
        .subsequent_indent(&blanks)
        .break_words(false)
        .word_splitter(WordSplitter::NoHyphenation);
    textwrap::fill(text, options)
}

/// `things` behind `label`, separated by commas, with line breaks only after a comma.
pub(crate) fn listed(label: &str, things: &[String]) -> String {
    // A no-break space keeps a thing on one line.
    let things: Vec<String> = things.iter().map(|thing| thing.replace(' ', "\u{a0}")).collect();
    folded(label, &things.join(", ")).replace('\u{a0}', " ")
}

/// `text` behind `label`, with line breaks only after a comma.
pub(crate) fn at_commas(label: &str, text: &str) -> String {
    listed(label, &text.split(", ").map(str::to_owned).collect::<Vec<_>>())
}

/// A number of things in words.
pub(crate) fn counted(count: usize, thing: &str) -> String {
    format!("{count} {thing}{}", if count == 1 { "" } else { "s" })
}

/// Names of what is equal for a place of `room` characters: all, or the first and the number of the others.
pub(crate) fn shortened_names(names: &[&str], room: usize) -> String {
    let all = names.join(" = ");
    match names {
        [first, others @ ..] if all.chars().count() > room && !others.is_empty() => {
            format!("{first} + {}", others.len())
        }
        _ => all,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_text_is_folded_between_words() {
        let folded_text = folded("  time        ", "half-way word ".repeat(30).trim_end());
        assert!(folded_text.lines().count() > 2);
        for (index, line) in folded_text.lines().enumerate() {
            let start = if index == 0 { "  time        " } else { "              " };
            assert!(line.len() <= WIDTH && line.starts_with(start), "{line}");
            let words: Vec<&str> = line[start.len()..].split(' ').collect();
            assert!(words.iter().all(|word| ["half-way", "word"].contains(word)), "{line}");
        }
        assert_eq!(folded("", "short text"), "short text");
    }

    #[test]
    fn lists_are_folded_between_things() {
        let things: Vec<String> = (0..20).map(|n| format!("thing number {n}")).collect();
        for line in listed("all ", &things).lines() {
            assert!(line.len() <= WIDTH && !line.ends_with("thing") && !line.ends_with("number"));
        }
    }

    #[test]
    fn equal_names_that_have_no_room_are_counted() {
        assert_eq!(shortened_names(&["none"], 2), "none");
        assert_eq!(shortened_names(&["popc", "lolc"], 11), "popc = lolc");
        assert_eq!(shortened_names(&["lolc-spring", "popc"], 17), "lolc-spring + 1");
        assert_eq!(shortened_names(&["popc", "lolc", "tank"], 15), "popc + 2");
    }
}
