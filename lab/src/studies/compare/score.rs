//! What one entrant came to on one scene.

use serde::Serialize;

/// What one entrant came to on one scene; docs/compare.md defines every number.
///
/// What does not apply is `None`, and so is what is out of the range of the numbers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Score {
    /// The entrant.
    pub stabilizer: String,
    /// Whether the run was bounded and did not grow.
    pub stable: Option<bool>,
    /// Since when the plant has been in the band about its equilibrium without a break, s.
    #[serde(rename = "settling_time_s")]
    pub settling_time: Option<f64>,
    /// Largest force on the plant in contacts shorter than half a second, N.
    #[serde(rename = "peak_force_short_contact_n")]
    pub short_peak: Option<f64>,
    /// Largest force on the plant in contacts of half a second or more, N.
    #[serde(rename = "peak_force_long_contact_n")]
    pub long_peak: Option<f64>,
    /// What the environment gave beyond all it had been given, mJ.
    #[serde(rename = "energy_injected_mj")]
    pub energy_injected: Option<f64>,
    /// What the controller's force took out of the motion, mJ.
    #[serde(rename = "energy_taken_mj")]
    pub energy_taken: Option<f64>,
    /// Largest debt that a tick could not serve, mJ.
    #[serde(rename = "shortfall_mj")]
    pub shortfall: Option<f64>,
    /// Stiffness felt in contacts of half a second or more, N/m.
    #[serde(rename = "stiffness_felt_n_per_m")]
    pub stiffness_felt: Option<f64>,
    /// The same in percent of the wall's.
    #[serde(rename = "stiffness_felt_percent")]
    pub stiffness_percent: Option<f64>,
    /// Root mean square of the force on the plant less the ideal wall's in contact, of stable runs, N.
    #[serde(rename = "force_error_rms_n")]
    pub force_error: Option<f64>,
    /// Root mean square of the force on the plant between 5 and 50 Hz, N.
    #[serde(rename = "chatter_rms_n")]
    pub chatter: Option<f64>,
    /// Share of the ticks on which damping was injected, percent.
    #[serde(rename = "active_percent")]
    pub active: Option<f64>,
    /// Time of one step.
    #[serde(rename = "ns_per_step")]
    pub step_time: Option<StepTime>,
    /// Bytes that the stabilizer keeps from tick to tick, parameters included.
    pub state_bytes: usize,
}

/// The time of one step of a stabilizer, over some rounds: the only thing here that differs from run to run.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct StepTime {
    /// The middle round, ns.
    pub median: f64,
    /// The fastest round, ns.
    pub min: f64,
    /// The slowest round, ns.
    pub max: f64,
    /// How many rounds there were.
    pub rounds: usize,
    /// Always false: a clock was asked.
    pub deterministic: bool,
}
