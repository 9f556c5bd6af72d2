//! Teleoperators, closed to loops: what joins their two ends, and the run of each.

mod building;
mod entrant;
mod link;
pub(crate) mod rig;

pub use entrant::Entrant;
pub(crate) use rig::Tick;
