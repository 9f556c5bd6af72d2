//! Measures along a run, each defined once: [docs/compare.md](../../../docs/compare.md) has the equations.
//!
//! Each meter is generic over the scalar, so that the runs of a map are measured lane by lane with the bits of a single
//! run.

pub(crate) mod balance;
pub(crate) mod chatter;
pub(crate) mod energies;
pub(crate) mod fate;
pub(crate) mod force_error;
pub(crate) mod force_felt;
pub(crate) mod given;
pub(crate) mod law;
pub(crate) mod linear;
pub(crate) mod models;
pub(crate) mod physical;
pub(crate) mod quantile;
pub(crate) mod runs;
#[cfg(test)]
pub(crate) mod samples;
pub(crate) mod sanity;
pub(crate) mod settling;
pub(crate) mod share;
pub(crate) mod stiffness_felt;
pub(crate) mod stretches;
pub(crate) mod summary;
pub(crate) mod teleoperation;
pub(crate) mod timing;
pub(crate) mod trace;
pub(crate) mod verdict;
pub(crate) mod watch;

pub use balance::Balance;
pub(crate) use chatter::Chatter;
pub(crate) use energies::Energies;
pub(crate) use fate::{Fate, Watched};
pub(crate) use force_error::{ForceError, SolidError};
pub(crate) use given::device_damper;
pub use linear::{Limits, LinearPart};
pub(crate) use physical::Physical;
pub(crate) use sanity::Oddity;
pub(crate) use settling::Settling;
pub(crate) use share::Share;
pub(crate) use stiffness_felt::StiffnessFelt;
pub(crate) use summary::Summary;
pub(crate) use trace::Trace;
pub(crate) use verdict::{Verdict, Yardstick};
pub use watch::{GoOn, Watch};
