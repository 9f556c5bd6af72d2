//! The claims of the paper's section IV, each with a computed verdict.
//!
//! A claim is judged over an ensemble of [`Member`]s, which differ in what the paper does not state, and for two
//! controllers side by side: ours and the one that the paper prints ([`Steps`]). A run ends where it is decided
//! ([`Trace`]), so no number depends on the length of a run or on ticks at rest. The loop is homogeneous: lengths and
//! forces are compared with the paper's in proportion to the start, energies in proportion to its square.

mod balance;
mod claim;
mod ensemble;
mod influence;
mod interval;
mod measures;
mod member;
mod outcomes;
mod rows;
mod runs;
mod trace;
mod verdict;

pub use crate::measure::quantile::median;
pub use balance::Balance;
pub use claim::{Claim, Judged};
pub use ensemble::{Control, Loop, Run, Steps, measured, traces};
pub use influence::{Group, Influence};
pub use interval::clopper_pearson;
pub use measures::Measures;
pub use member::{Member, RATES, START, Unstated};
pub use outcomes::{Outcomes, Share};
pub use rows::claims;
pub use runs::{Runs, SOFT, STIFF, WALLS};
pub use trace::{Point, Trace};
pub use verdict::Verdict;
