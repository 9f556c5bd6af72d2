//! Where the energy of a run came from, where it went, and what became of the run.

mod account;
mod body;
mod fate;
mod law;
mod trial;

pub use account::Balance;
pub(crate) use fate::Fate;
pub(crate) use trial::{Feel, Trial};
