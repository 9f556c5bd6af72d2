//! Energies of a run by cause.

mod account;
mod body;
mod trial;

pub use account::Balance;
pub(crate) use trial::{Feel, Trial};
