//! The peers that are crates, each as its documentation advises for repeated short runs: nothing is recorded on the way,
//! the first step that is tried is a whole period, and what can be kept from period to period is.
//!
//! A held force jumps at every period, so each peer starts anew there: its right side is another function.

mod differential_equations;
mod diffsol;
mod ode_solvers;
mod russell_ode;

use crate::row::Row;

/// All of them.
pub(crate) fn rows() -> Vec<Row> {
    let mut rows = ode_solvers::rows();
    rows.extend(differential_equations::rows());
    rows.extend(diffsol::rows());
    rows.extend(russell_ode::rows());
    rows
}

/// Steps per period, such that as many lengths of `PERIOD / steps` make a period to the bit: `ode_solvers` and
/// `russell_ode` round their number up.
const STEPS: &[u32] = &[1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 25, 32, 50, 64, 100];
