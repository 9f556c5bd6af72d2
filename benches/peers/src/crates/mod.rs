//! Peers that are crates, each used as its documentation advises for repeated short runs: nothing is recorded on the
//! way, the first trial step is a whole period, and everything reusable is kept from period to period.
//!
//! A held force jumps at every period, so each peer starts anew there: its right-hand side is a new function.

mod differential_equations;
mod diffsol;
mod ode_solvers;
mod russell_ode;

use crate::row::Row;

/// The rows of all crates.
pub(crate) fn rows() -> Vec<Row> {
    let mut rows = ode_solvers::rows();
    rows.extend(differential_equations::rows());
    rows.extend(diffsol::rows());
    rows.extend(russell_ode::rows());
    rows
}

/// Steps per period for which that many lengths of `PERIOD / steps` sum to a period to the bit: `ode_solvers` and
/// `russell_ode` round the number of steps up.
const STEPS: &[u32] = &[1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 25, 32, 50, 64, 100];
