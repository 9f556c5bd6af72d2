//! A comparison as it is shown.

use std::fmt;

use super::table::Table;
use lyapunov_figures::Figure;

/// A comparison as it is shown; in the terminal it takes 100 columns at most, but for a name that is longer.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// What the file is called.
    pub name: String,
    /// The file in one line.
    pub setting: String,
    /// What the columns are compared with, in one line.
    pub start: String,
    /// A row for each contestant.
    pub(crate) tables: Vec<Table>,
    /// The runs, drawn.
    pub figure: Figure,
    /// What the figure shows, a sentence or two.
    pub caption: &'static str,
    /// The curves of the figure as comma-separated values, in numbers that read back exactly.
    pub csv: String,
}

impl fmt::Display for Sheet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}: {}\n{}", self.name, self.setting, self.start)?;
        self.tables.iter().try_for_each(|table| write!(f, "\n{table}"))
    }
}
