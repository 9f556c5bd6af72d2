//! Teleoperators, closed to loops: the links between their two ends, and the run of each.

mod building;
mod entrant;
mod link;
pub(crate) mod rig;

pub use entrant::Entrant;
pub(crate) use rig::Tick;
