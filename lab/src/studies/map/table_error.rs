//! Faults of a map's table.

use std::{fmt, io};

use crate::text::shorten;

/// Fault of a table.
#[derive(Debug)]
pub enum TableError {
    /// The head is not that of a map of this version.
    TableHeader(String),
    /// The columns after the stabilizer's are not those of this version.
    Columns(String),
    /// A row that no map has.
    Row {
        /// The number of the row, from 1.
        row: u64,
        /// The text that is there instead.
        text: String,
    },
    /// A row of an unfinished table that does not have its checksum.
    Damaged {
        /// The number of the row, from 1.
        row: u64,
    },
    /// Rows after the last one of the map.
    Excess,
    /// The table cannot be read.
    Unreadable(io::Error),
}

impl From<io::Error> for TableError {
    fn from(error: io::Error) -> Self {
        Self::Unreadable(error)
    }
}

impl fmt::Display for TableError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TableHeader(problem) => write!(f, "this is not the table of a map: {problem}"),
            Self::Columns(found) => {
                write!(f, "its columns are `{}`, and this version has others", shorten(found))
            }
            Self::Row { row, text } => {
                write!(f, "row {row} below the head is `{}`, which no map has there", shorten(text))
            }
            Self::Damaged { row } => {
                write!(
                    f,
                    "row {row} below the head does not match its checksum: it has changed since it was written"
                )
            }
            Self::Excess => f.write_str("it goes on after its last cell"),
            Self::Unreadable(error) => write!(f, "it cannot be read: {error}"),
        }
    }
}

impl std::error::Error for TableError {}
