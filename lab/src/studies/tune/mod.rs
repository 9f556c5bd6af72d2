//! Tuning of stabilizers, each with the same number of runs.
//!
//! docs/tune.md defines the terms.

mod cost;
mod document;
mod objective;
mod picture;
mod report;
mod search;
mod setting;
mod study;
mod table;
mod trial;

pub use document::document;
pub use objective::{Objective, ObjectiveError, Term};
pub use picture::figure;
pub use report::{csv, page};
pub use setting::{Number, Setting};
pub use study::{Change, TuneError, Tuned, Tuning, Watch};
pub use table::table;
pub use trial::Trial;
