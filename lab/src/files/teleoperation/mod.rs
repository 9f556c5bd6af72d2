//! Teleoperator files: a master in a hand and a slave before a wall, joined by a channel.
//!
//! A [`Teleoperator`] is a separate kind of file from a [`Scene`](crate::Scene): it has two devices, a channel between
//! them and a port at each end. docs/teleoperation.md has its equations.

mod check;
mod defaults;
mod keys;
mod parts;
mod teleoperator;
#[cfg(test)]
mod tests;

pub use defaults::Layers;
pub(crate) use keys::BOOK;
pub use parts::{
    Channel, Coordination, DriftCompensated, Master, Slave, Stabilizer, TwoLayer, Wall,
    WaveVariables,
};
pub use teleoperator::{Teleoperator, schema_text};
