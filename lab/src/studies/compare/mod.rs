//! Stabilizers on the same scenes, side by side: `lyapunov compare`.
//!
//! [`Entrants`] take part, your own with one line more; a [`Comparison`] runs them all on a scene, measures each of the
//! [`Column`]s that docs/compare.md defines, and displays as a table. [`document`] writes comparisons as JSON.

mod broken;
mod column;
mod compared;
mod comparison;
mod contacts;
mod cost;
mod document;
mod energies;
mod entrant_run;
mod entrants;
mod equal;
mod look_at;
pub mod models;
mod picture;
mod report;
mod score;
mod sheet;
mod table;
pub mod teleoperation;
#[cfg(test)]
mod tests;
mod trade_off;

pub use crate::simulate::Subject;
pub use crate::simulate::family::{Judgement, Settings};
pub use crate::text::names::{Named, Names, NamesError};
pub use broken::Broken;
pub(crate) use broken::mark as mark_broken;
pub use column::{Column, UnknownColumn};
pub use compared::{Compared, RunError, Watch};
pub use comparison::{CompareError, Comparison};
pub use document::document;
pub use energies::Energies;
pub use entrant_run::Watch as SharedWatch;
pub(crate) use entrant_run::score_under;
pub use entrants::Entrants;
pub(crate) use report::field;
pub use report::{csv, report};
pub use score::{Score, StepTime};
pub use sheet::{Sheet, page};
pub use trade_off::TradeOff;
