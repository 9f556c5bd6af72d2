//! Reasons why a map is not finished.

use std::fmt;

use super::grid::GridError;
use crate::show::OutputError;

/// Reason why a map is not finished.
#[derive(Debug)]
pub enum RunError {
    /// A cell whose values make no scene.
    Cell(GridError),
    /// The outcomes could not be written.
    Output(OutputError),
    /// Threads could not be started.
    Threads(String),
    /// The caller stopped it; the outcomes handed out before are valid.
    Stopped,
}

impl fmt::Display for RunError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Cell(error) => error.fmt(f),
            Self::Output(error) => error.fmt(f),
            Self::Threads(error) => {
                write!(f, "threads cannot be started: {error}\n  = give fewer threads")
            }
            Self::Stopped => f.write_str("the map was stopped"),
        }
    }
}

impl std::error::Error for RunError {}

impl From<GridError> for RunError {
    fn from(error: GridError) -> Self {
        Self::Cell(error)
    }
}

impl From<OutputError> for RunError {
    fn from(error: OutputError) -> Self {
        Self::Output(error)
    }
}
