//! Models of plants, closed to loops: the stabilizers that their ports are given, and the run of each.

mod building;
mod entrant;
mod rig;

pub(crate) use building::built;
pub use entrant::Entrant;
pub(crate) use rig::Tick;
