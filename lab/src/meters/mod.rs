//! What is measured along a run, defined once: [docs/compare.md](../../../docs/compare.md) has the equations.
//!
//! Each meter is generic over the scalar, so that the runs of a map are measured lane by lane with the bits of a
//! single run.

mod boundedness;
mod chatter;
mod energies;
mod settling;
mod share;

pub(crate) use boundedness::{Boundedness, Criterion};
pub(crate) use chatter::Chatter;
pub(crate) use energies::Energies;
pub(crate) use settling::Settling;
pub(crate) use share::{Share, Split};
