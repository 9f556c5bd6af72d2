//! Models of plants, closed to loops: the stabilizers at their ports, and the run of each.

mod building;
mod entrant;
mod rig;

pub(crate) use building::built;
pub use entrant::Entrant;
pub(crate) use rig::Tick;
