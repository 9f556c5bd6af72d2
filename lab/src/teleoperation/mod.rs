//! Teleoperators from files: a master in a hand and a slave before a wall, joined by a channel, and what stabilizes them.
//!
//! A [`Teleoperator`] is a document of its own beside the [`Scene`](crate::Scene): it has two devices, a channel between
//! them and a port at each end. docs/teleoperation.md has its equations.

mod building;
mod check;
mod comparison;
mod contestant;
mod coordination;
mod document;
mod end;
mod keys;
mod link;
mod meter;
mod parts;
mod picture;
mod rig;
mod score;
mod table;
mod teleoperator;
#[cfg(test)]
mod tests;

pub use comparison::Comparison;
pub use contestant::Contestant;
pub use meter::BOUND;
pub use parts::{Channel, Coordination, Master, Slave, Stabilizer, Wall};
pub use score::{Curves, Score};
pub use teleoperator::{Teleoperator, schema_text};
