//! Stiffness limits in the terminal.

use std::fmt;

use crate::measure::Limits;
use crate::show::table::{Heading, Table};
use crate::text::{found, given};

impl fmt::Display for Limits {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.stiffness {
            Some(own) => writeln!(f, "  stiffness    {} N/m in the scene", given(own))?,
            None => writeln!(f, "  stiffness    none")?,
        }
        match self.spectral_radius {
            Some(radius) => writeln!(f, "  radius       {radius:.10} in contact{}", word(radius))?,
            None => writeln!(f, "  radius       none")?,
        }
        let headings = [
            Heading::word("limit"),
            Heading::number("at most N/m"),
            Heading::word("the scene's own is"),
        ];
        let rows = self.named().into_iter().map(|(key, name, limit)| {
            [name.into(), limit.into(), limit.map(|limit| self.place(key, limit)).into()]
        });
        let table = Table::new(headings).with_rows(rows).to_string();
        write!(f, "\n{}", textwrap::indent(&table, "  "))?;
        for (index, note) in self.notes.iter().enumerate() {
            let gap = if index == 0 { "\n" } else { "" };
            writeln!(f, "{gap}  - {note}")?;
        }
        Ok(())
    }
}

impl Limits {
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
