//! The claims of the paper's section IV, each with a computed verdict.
//!
//! Every verdict rests on an ensemble of starts within 10 % of the paper's, because the loop at 8 kN/m is chaotic and a
//! single late trace means nothing. A claim is reproduced where it holds for at least 95 % of the starts, not
//! reproduced where it holds for at most 5 %, and undecided in between. The loop is homogeneous, so lengths and forces
//! are compared with the paper's in proportion to the start, energies in proportion to its square.

mod area;
mod balance;
mod ensemble;
mod measures;
mod rows;
mod sensitivity;

pub use area::{Grid, stable_share};
pub use balance::Balance;
pub use ensemble::{Control, DURATION, START, Setting, Trace, run, starts};
pub use measures::{Measures, median};
pub(super) use rows::number;
pub use rows::{Claim, Verdict, claims};
pub use sensitivity::{MovedClaim, Reading, sensitivity};
