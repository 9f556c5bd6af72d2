//! Score of one entrant on one scene.

use serde::Serialize;

use crate::measure::Verdict;
use crate::simulate::family::Judgement;

/// The score of one entrant on one scene; docs/compare.md defines every number.
///
/// Numbers that do not apply or are out of range are `None`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Score {
    /// The entrant.
    pub stabilizer: String,
    /// The verdict on the run.
    pub verdict: Verdict,
    /// The time since when the plant has stayed in the band about its equilibrium, s.
    #[serde(rename = "settling_time_s")]
    pub settling_time: Option<f64>,
    /// Largest force on the plant in contacts shorter than half a second, N.
    #[serde(rename = "peak_force_short_contact_n")]
    pub short_peak: Option<f64>,
    /// Largest force on the plant in contacts of half a second or more, N.
    #[serde(rename = "peak_force_long_contact_n")]
    pub long_peak: Option<f64>,
    /// The energy that the environment gave beyond all it had been given, mJ.
    #[serde(rename = "energy_injected_mj")]
    pub energy_injected: Option<f64>,
    /// The energy that the controller's force took out of the motion, mJ.
    #[serde(rename = "energy_taken_mj")]
    pub energy_taken: Option<f64>,
    /// Largest debt that a tick could not serve, mJ; `None` of an own entrant that tells neither observed energy nor shortfall.
    #[serde(rename = "shortfall_mj")]
    pub shortfall: Option<f64>,
    /// Stiffness felt in contacts of half a second or more, N/m.
    #[serde(rename = "stiffness_felt_n_per_m")]
    pub stiffness_felt: Option<f64>,
    /// The stiffness felt in percent of the wall's.
    #[serde(rename = "stiffness_felt_percent")]
    pub stiffness_percent: Option<f64>,
    /// Root mean square of the force on the plant minus the ideal wall's in contact, of runs that do not grow, N.
    #[serde(rename = "force_error_rms_n")]
    pub force_error: Option<f64>,
    /// Root mean square of the force on the plant between 5 and 50 Hz, N.
    #[serde(rename = "chatter_rms_n")]
    pub chatter: Option<f64>,
    /// Share of the ticks on which damping was injected, percent; `None` for a stabilizer that adds no damping, or tells no `alpha`.
    #[serde(rename = "active_percent")]
    pub active: Option<f64>,
    /// Time of one step.
    #[serde(rename = "ns_per_step")]
    pub step_time: Option<StepTime>,
    /// Bytes that the stabilizer keeps from tick to tick, parameters included.
    pub state_bytes: usize,
    /// The most that the port had physically given beyond all it had taken, mJ.
    #[serde(rename = "energy_given_mj")]
    pub energy_given: Option<f64>,
    /// The most that the port had given beyond what it and the device's damper had taken, mJ; none with jitter.
    #[serde(rename = "energy_given_beyond_damper_mj")]
    pub energy_given_beyond_damper: Option<f64>,
    /// Force on the plant, of runs that do not grow, in percent of the environment's own law on the true motion.
    #[serde(rename = "force_felt_percent")]
    pub force_felt: Option<f64>,
    /// Whether the loop is bounded without a stabilizer and grows under this one; none where `none` takes no part.
    pub broke_it: Option<bool>,
    /// The numbers to judge the entrant by; none for an entrant of your own.
    pub judged_by: Option<Judgement>,
}

/// The time of one step of a stabilizer, over some rounds: the only value here that differs from run to run.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct StepTime {
    /// The middle round, ns.
    pub median: f64,
    /// The fastest round, ns.
    pub min: f64,
    /// The slowest round, ns.
    pub max: f64,
    /// The number of rounds.
    pub rounds: usize,
    /// Always false: the values come from a clock.
    pub deterministic: bool,
}
