//! Errors of a log, or of a setting for it, that cannot be used.

use std::fmt;
use std::io;

use super::bad::BadRows;
use crate::text::{folded, legible};

/// Reason why a log, or a setting for it, cannot be used, with a remedy.
#[derive(Debug)]
pub struct LogError {
    message: String,
    help: Option<String>,
}

impl LogError {
    /// Error without a remedy yet.
    pub(crate) fn new(message: impl Into<String>) -> Self {
        Self { message: message.into(), help: None }
    }

    /// Error at a line of a log.
    pub(crate) fn at(name: &str, line: u64, message: impl fmt::Display) -> Self {
        let name = legible(name);
        Self::new(format!("{name}:{line}: {message}"))
    }

    /// Error of a log as a whole.
    pub(crate) fn about(name: &str, message: impl fmt::Display) -> Self {
        let name = legible(name);
        Self::new(format!("{name}: {message}"))
    }

    /// Error of the stream behind a log.
    pub(crate) fn unreadable(name: &str, error: &io::Error) -> Self {
        Self::about(name, format!("it cannot be read: {error}"))
    }

    /// Error of a log with fewer than two good rows.
    pub(crate) fn too_few(name: &str, bad: &BadRows) -> Self {
        let error = Self::about(name, "fewer than two good rows, so nothing moved");
        error.with_help(bad.blamed().unwrap_or_else(|| "give a log of a motion".to_owned()))
    }

    pub(crate) fn with_help(self, help: impl Into<String>) -> Self {
        Self { help: Some(help.into()), ..self }
    }

    /// The fault, with its place.
    pub fn message(&self) -> &str {
        &self.message
    }

    /// The remedy.
    pub fn help(&self) -> Option<&str> {
        self.help.as_deref()
    }
}

impl fmt::Display for LogError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)?;
        let Some(help) = &self.help else { return Ok(()) };
        write!(f, "\n{}", folded("  = ", help))
    }
}

impl std::error::Error for LogError {}
