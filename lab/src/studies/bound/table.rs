//! Stiffness limits in the terminal.

use std::fmt;

use crate::measure::Limits;
use crate::show::table::{Heading, Table};
use crate::text::{folded, found, given, near_one};

impl fmt::Display for Limits {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&lines(self))?;
        write!(f, "\n{}", textwrap::indent(&self.table().to_string(), "  "))?;
        for (index, note) in self.notes.iter().enumerate() {
            let gap = if index == 0 { "\n" } else { "" };
            writeln!(f, "{gap}{}", folded("  - ", note))?;
        }
        Ok(())
    }
}

/// The scene's own stiffness and spectral radius, a line each.
pub(super) fn lines(limits: &Limits) -> String {
    let own = limits
        .stiffness
        .map_or_else(|| "none".to_owned(), |own| format!("{} N/m in the scene", given(own)));
    let radius = limits.spectral_radius.map_or_else(
        || "none".to_owned(),
        |radius| format!("{} in contact{}", near_one(radius, 10), word(radius)),
    );
    format!("  stiffness    {own}\n  radius       {radius}\n")
}

impl Limits {
    /// The limits, and how the scene's own stiffness compares.
    pub(super) fn table(&self) -> Table {
        let headings = [
            Heading::word("limit"),
            Heading::number("at most N/m"),
            Heading::word("the scene's own is"),
        ];
        let rows = self.named().into_iter().map(|(key, name, limit)| {
            [name.into(), limit.into(), limit.map(|limit| self.place(key, limit)).into()]
        });
        Table::new(headings).with_rows(rows)
    }

    /// The scene's own stiffness, as compared with a limit.
    fn place(&self, key: &str, limit: f64) -> String {
        let from = self.exact_from.filter(|_| key == "exact_max_stiffness").unwrap_or(0.0);
        match self.stiffness {
            None => "-".to_owned(),
            Some(own) if own < 0.0 => "below 0: only the radius tells".to_owned(),
            Some(own) if own < from => format!("too soft: stable from {} N/m on", found(from)),
            Some(own) if own <= limit => {
                format!("within it, at {} % of it", found(100.0 * own / limit))
            }
            Some(_) if limit == 0.0 => "beyond it: no stiffness passes".to_owned(),
            Some(own) => format!("{} times too stiff", found(own / limit)),
        }
    }
}

fn word(radius: f64) -> &'static str {
    if radius < 1.0 {
        ": the linear loop is stable"
    } else if radius > 1.0 {
        ": the linear loop is not stable"
    } else {
        ": the linear loop is just not stable"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_radius_of_one_is_just_not_stable() {
        let words = [0.999, 1.0, 1.001].map(word);
        assert_eq!(words.map(|it| it.contains("is stable")), [true, false, false]);
        assert_eq!(words.map(|it| it.contains("just not")), [false, true, false]);
    }
}
