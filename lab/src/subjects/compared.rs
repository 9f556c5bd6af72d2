//! All contestants on one file.

use std::fmt;
use std::ops::ControlFlow;

use lyapunov::ParameterError;

use super::sheet::Sheet;

/// Is told now and then how many more ticks are done; says whether to go on.
pub type Watch<'a> = dyn Fn(u64) -> ControlFlow<()> + 'a;

/// What all contestants came to on one file that is no scene.
pub trait Compared: Sized {
    /// The file.
    type File;

    /// What such a file is, in one word.
    const NOUN: &'static str;

    /// The heading of a report.
    const TITLE: &'static str;

    /// Who the contestants are, in a paragraph of a report.
    const ABOUT: &'static str;

    /// The ticks of all contestants together.
    fn ticks(file: &Self::File) -> u64;

    /// Runs all contestants on `file`, which is called `name`.
    ///
    /// # Errors
    /// [`CompareError::Stopped`] if `watch` says so; a file that was never checked.
    fn of(name: &str, file: &Self::File, watch: &Watch<'_>) -> Result<Self, CompareError>;

    /// The comparison as it is shown.
    fn sheet(&self) -> Sheet;

    /// The comparisons as JSON.
    ///
    /// # Errors
    /// None: every part can be written as JSON.
    fn document(comparisons: &[Self]) -> serde_json::Result<String>;
}

/// Why there is no comparison.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CompareError {
    /// The file was never checked: its loop cannot be built.
    Parameter(ParameterError),
    /// Whoever watched said so.
    Stopped,
}

impl fmt::Display for CompareError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Parameter(error) => error.fmt(f),
            Self::Stopped => f.write_str("the comparison was stopped"),
        }
    }
}

impl std::error::Error for CompareError {}
