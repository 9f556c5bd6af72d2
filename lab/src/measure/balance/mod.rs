//! Energies of a run by cause, and the verdict on the run.

mod account;
mod body;
mod fate;
mod trial;

pub use account::Balance;
pub(crate) use fate::Fate;
pub(crate) use trial::{Feel, Trial};
