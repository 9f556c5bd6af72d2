//! Comparison of all entrants on one file.

use std::fmt;
use std::ops::ControlFlow;

use lyapunov::ParameterError;
use serde::Serialize;

use super::sheet::Sheet;
pub use crate::measure::Watch;
use crate::show::csv;
use crate::text::names::{Named, Names};

/// Ticks between two reports of progress.
pub(super) const BREATH: u64 = 1 << 14;

/// Results of all entrants on one file that is not a scene.
pub trait Compared: Sized {
    /// The file.
    type File;

    /// An entrant.
    type Entrant: Named;

    /// The numbers of an entrant.
    type Score: Serialize;

    /// The kind of file, in one word.
    const NOUN: &'static str;

    /// The heading of a report.
    const TITLE: &'static str;

    /// All entrants, in a paragraph of a report.
    const ABOUT: &'static str;

    /// The ticks of each entrant.
    fn ticks(file: &Self::File) -> u64;

    /// Runs `entrants` on `file`, whose name is `name`.
    ///
    /// # Errors
    /// [`RunError::Stopped`] if `watch` stops the runs; a file that was never checked.
    fn of(
        name: &str,
        file: &Self::File,
        entrants: &Names<Self::Entrant>,
        watch: &Watch<'_>,
    ) -> Result<Self, RunError>;

    /// The comparison as it is shown.
    fn sheet(&self) -> Sheet;

    /// The comparisons as JSON, and the files that were `left_out` with the reasons.
    fn document(comparisons: &[Self], left_out: &[String]) -> String;

    /// The rows of the JSON as comma-separated values, in numbers that read back exactly.
    fn rows(comparisons: &[Self]) -> String {
        csv::named_records(Self::NOUN, comparisons.iter().flat_map(Self::named_scores))
    }

    /// The scores of the entrants, each with the name of the file.
    fn named_scores(&self) -> impl Iterator<Item = (&str, &Self::Score)>;
}

/// Reason why there is no comparison.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RunError {
    /// The file was never checked: its loop cannot be built.
    Parameter(ParameterError),
    /// `watch` stopped the runs.
    Stopped,
}

impl fmt::Display for RunError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Parameter(error) => error.fmt(f),
            Self::Stopped => f.write_str("the comparison was stopped"),
        }
    }
}

impl std::error::Error for RunError {}

impl From<ParameterError> for RunError {
    fn from(error: ParameterError) -> Self {
        Self::Parameter(error)
    }
}

/// Runs a loop of `total` ticks at most and gives each to `add`; calls `watch` after every `breath` ticks.
pub(super) fn watched<T>(
    (total, breath): (u64, u64),
    watch: &Watch<'_>,
    run: impl FnOnce(&mut dyn FnMut(T) -> ControlFlow<()>) -> Result<(), ParameterError>,
    mut add: impl FnMut(T),
) -> Result<(), RunError> {
    let mut ticks = 0;
    let mut flow = ControlFlow::Continue(());
    run(&mut |tick| {
        add(tick);
        ticks += 1;
        if ticks % breath == 0 {
            flow = watch(breath);
        }
        flow
    })?;
    // Ticks not run count as done: a run that leaves the range has no more.
    let stopped = flow.is_break() || watch(total - ticks / breath * breath).is_break();
    if stopped { Err(RunError::Stopped) } else { Ok(()) }
}
