//! Hard cases that stay stable: `lyapunov hard`.
//!
//! A [`Catalogue`] of [`Case`]s, each with what makes it hard, a bound, a run of the paper's steps as printed
//! ([`Naive`]) and runs of the shipped stabilizer in `f64`, `f32` and lanes. Whatever is measured is measured beside
//! the library. [`Case::with`] tries a stabilizer of one's own.

mod balance;
mod case;
mod cases;
mod double;
mod naive;
mod report;
mod table;
mod tally;
mod trial;
mod watched;

pub use case::{Case, Outcome, Row, Verdicts};
pub use naive::Naive;
pub use tally::Tally;
pub use trial::{HardError, Own};

use std::fmt;
use std::ops::ControlFlow;

use rayon::prelude::*;
use serde::Serialize;

/// What came of the whole catalogue: `hard.json`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Catalogue {
    /// One for each case.
    pub rows: Vec<Row>,
}

impl Catalogue {
    /// The cases.
    pub fn cases() -> Vec<Case> {
        cases::all()
    }

    /// Runs all cases, on all cores; `watch` is told of each that is done, and may end it.
    ///
    /// # Errors
    /// As [`HardError`] tells.
    pub fn run(watch: &(dyn Fn() -> ControlFlow<()> + Sync)) -> Result<Self, HardError> {
        let rows = Self::cases().into_par_iter().map(|case| {
            let row = case.row()?;
            match watch() {
                ControlFlow::Continue(()) => Ok(row),
                ControlFlow::Break(()) => Err(HardError::Stopped),
            }
        });
        Ok(Self { rows: rows.collect::<Result<_, _>>()? })
    }

    /// Whether every case passed.
    pub fn passed(&self) -> bool {
        self.rows.iter().all(|row| row.passed)
    }

    /// As a page in HTML that needs nothing else; `command` is what made it.
    pub fn report(&self, command: &str) -> String {
        report::page(self, command)
    }

    /// As JSON.
    ///
    /// # Errors
    /// None: every part can be written as JSON.
    pub fn document(&self) -> serde_json::Result<String> {
        serde_json::to_string_pretty(self).map(|text| text + "\n")
    }
}

impl fmt::Display for Catalogue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        table::write(self, f)
    }
}
