//! What one contestant came to on one teleoperator.

use serde::Serialize;

use super::contestant::Contestant;

/// What one contestant came to on one teleoperator; docs/teleoperation.md defines every number.
///
/// What is out of the range of the numbers is `None`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Score {
    /// The contestant.
    pub stabilizer: &'static str,
    /// Whether the run stayed within the range of the scalar and its energy within [`BOUND`](super::BOUND) times the start's.
    pub bounded: bool,
    /// The largest energy of devices, hand and wall.
    #[serde(rename = "energy_largest_mj")]
    pub energy: Option<f64>,
    /// The largest speed of either device within the last tenth of the run.
    #[serde(rename = "speed_end_mm_per_s")]
    pub speed: Option<f64>,
    /// The largest distance between master and slave.
    #[serde(rename = "error_largest_mm")]
    pub error: Option<f64>,
    /// By how much the master is ahead of the slave at the last tick.
    #[serde(rename = "error_end_mm")]
    pub error_end: Option<f64>,
    /// By how much the commanded position is ahead of the master at the last tick.
    #[serde(rename = "drift_end_mm")]
    pub drift: Option<f64>,
    /// The largest force that the link puts on the master.
    #[serde(rename = "force_felt_n")]
    pub felt: Option<f64>,
    /// The largest force of the wall; `None` without one.
    #[serde(rename = "force_contact_n")]
    pub contact: Option<f64>,
    /// The least that both ports together have absorbed, with what corrections were about to burn.
    #[serde(rename = "energy_least_mj")]
    pub kept: Option<f64>,
    /// Largest debt of both ends together that a tick could not serve.
    #[serde(rename = "shortfall_mj")]
    pub shortfall: Option<f64>,
    /// Share of the ticks on which the correction at the master burns more than rounding, percent.
    #[serde(rename = "active_master_percent")]
    pub active_master: f64,
    /// Share of the ticks on which the correction at the slave burns more than rounding, percent.
    #[serde(rename = "active_slave_percent")]
    pub active_slave: f64,
}

/// Time in s and position in m, at every tick, or of a long run the extremes of each of some thousand stretches.
#[derive(Clone, Debug, PartialEq)]
pub struct Curves {
    /// The master's.
    pub master: Vec<(f64, f64)>,
    /// The slave's.
    pub slave: Vec<(f64, f64)>,
}

/// The numbers of one contestant, and positions over time.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Outcome {
    pub(super) contestant: Contestant,
    pub(super) score: Score,
    pub(super) curves: Curves,
}
