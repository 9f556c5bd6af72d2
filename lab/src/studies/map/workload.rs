//! Cost of a map's computation.

use serde::Serialize;

/// Cost of a computation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Workload {
    /// The number of cells.
    pub cells: u64,
    /// Ticks of all rollouts, each counted to the end of its run even if it was stopped before.
    pub rollout_steps: u64,
    /// Time spent on the verdicts, s.
    pub kernel_seconds: f64,
    /// Time spent on measuring the runs that do not grow, s; 0 where that happens along with the verdict.
    pub measures_seconds: f64,
}
