//! Stabilizers on the same scenes, side by side: `lyapunov compare`.
//!
//! [`Contestants`] take part, one's own with one line more; a [`Comparison`] runs them all on a scene, measures
//! each of the [`Column`]s that docs/compare.md defines, and shows itself as a table. [`document`] writes
//! comparisons as JSON.

mod bout;
mod column;
mod comparison;
mod contacts;
mod contestants;
mod cost;
mod document;
mod energies;
mod picture;
#[cfg(test)]
pub(crate) mod samples;
mod score;
mod setting;
mod table;
#[cfg(test)]
mod tests;
mod trace;
mod trade_off;

pub use column::{Column, NoColumn};
pub use comparison::{CompareError, Comparison};
pub use contestants::{Contestants, Settings};
pub use document::document;
pub use energies::Energies;
pub use score::{Score, StepTime};
pub(crate) use trace::Trace;
pub use trade_off::TradeOff;
