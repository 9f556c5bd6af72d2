//! What one contestant came to on one model.

use serde::Serialize;

use super::contestant::Contestant;

/// What one contestant came to on one model; docs/any-plant.md defines every number.
///
/// What is out of the range of the numbers is `None`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Score {
    /// The contestant.
    pub stabilizer: &'static str,
    /// Whether the run stayed within the range of the scalar and V within [`BOUND`](super::BOUND) times its start.
    pub bounded: bool,
    /// The largest V.
    #[serde(rename = "v_largest")]
    pub largest: Option<f64>,
    /// V at the last tick.
    #[serde(rename = "v_end")]
    pub end: Option<f64>,
    /// The largest size of the effort on the plant, of all inputs together.
    #[serde(rename = "effort_largest")]
    pub effort: Option<f64>,
    /// Share of the ticks on which damping was injected, percent.
    #[serde(rename = "active_percent")]
    pub active: f64,
    /// Largest debt that a tick could not serve.
    pub shortfall: Option<f64>,
    /// What the stabilizer's part of the effort took from V.
    #[serde(rename = "energy_taken")]
    pub taken: Option<f64>,
}

/// The numbers of one contestant, and V over time.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Outcome {
    pub(super) contestant: Contestant,
    pub(super) score: Score,
    /// Time in s and V.
    pub(super) curve: Vec<(f64, f64)>,
}
