//! Measures along a run, each defined once: [docs/compare.md](../../../docs/compare.md) has the equations.
//!
//! Each meter is generic over the scalar, so that the runs of a map are measured lane by lane with the bits of a single
//! run.

pub(crate) mod balance;
pub(crate) mod chatter;
pub(crate) mod energies;
pub(crate) mod fate;
pub(crate) mod linear;
pub(crate) mod models;
#[cfg(test)]
pub(crate) mod samples;
pub(crate) mod settling;
pub(crate) mod share;
pub(crate) mod stretches;
pub(crate) mod summary;
pub(crate) mod teleoperation;
pub(crate) mod timing;
pub(crate) mod trace;
pub(crate) mod verdict;

pub use balance::Balance;
pub(crate) use chatter::Chatter;
pub(crate) use energies::Energies;
pub(crate) use fate::Fate;
pub use linear::{Limits, LinearPart};
pub(crate) use settling::Settling;
pub(crate) use share::Share;
pub(crate) use summary::Summary;
pub(crate) use trace::Trace;
pub(crate) use verdict::{Verdict, Yardstick};
