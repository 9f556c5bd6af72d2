//! Why a log cannot be observed.

use std::fmt;
use std::io;

use super::bad::BadRows;
use crate::scene::printable;

/// The widest line of help.
const WIDTH: usize = 96;

/// Why a log cannot be observed: what is wrong, and what would be right.
#[derive(Debug)]
pub struct ObserveError {
    message: String,
    help: Option<String>,
}

impl ObserveError {
    /// An error without a remedy yet.
    pub(super) fn new(message: impl Into<String>) -> Self {
        Self { message: message.into(), help: None }
    }

    /// An error about a place in a log.
    pub(super) fn at(name: &str, line: u64, message: impl fmt::Display) -> Self {
        let name: String = name.chars().map(printable).collect();
        Self::new(format!("{name}:{line}: {message}"))
    }

    /// An error about a log as a whole.
    pub(super) fn about(name: &str, message: impl fmt::Display) -> Self {
        let name: String = name.chars().map(printable).collect();
        Self::new(format!("{name}: {message}"))
    }

    /// The error of the stream behind a log.
    pub(super) fn unreadable(name: &str, error: &io::Error) -> Self {
        Self::about(name, format!("it cannot be read: {error}"))
    }

    /// The error of a log with fewer than two good rows.
    pub(super) fn too_few(name: &str, bad: &BadRows) -> Self {
        let mut message = "fewer than two good rows, so nothing moved".to_owned();
        if let Some(first) = bad.first.first() {
            message +=
                &format!("; {} bad, the first at line {}: {}", bad.count, first.line, first.reason);
        }
        Self::about(name, message).with_help(bad.remedy().unwrap_or("give a log of a motion"))
    }

    pub(super) fn with_help(self, help: impl Into<String>) -> Self {
        Self { help: Some(help.into()), ..self }
    }

    /// What is wrong, with its place.
    pub fn message(&self) -> &str {
        &self.message
    }

    /// What would be right.
    pub fn help(&self) -> Option<&str> {
        self.help.as_deref()
    }
}

impl fmt::Display for ObserveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)?;
        let Some(help) = &self.help else { return Ok(()) };
        f.write_str("\n  =")?;
        let mut column = 3;
        for word in help.split(' ') {
            let length = word.chars().count();
            if column + 1 + length > WIDTH {
                f.write_str("\n   ")?;
                column = 3;
            }
            write!(f, " {word}")?;
            column += 1 + length;
        }
        Ok(())
    }
}

impl std::error::Error for ObserveError {}
