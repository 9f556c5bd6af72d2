//! A summary as JSON.

use serde::Serialize;

use super::{LATE, MILLI, Summary};

#[derive(Serialize)]
struct Document<'a> {
    scene: &'a str,
    rows: u64,
    complete: bool,
    settled: bool,
    settling_time_s: Option<f64>,
    equilibrium_mm: Option<f64>,
    band_mm: Option<f64>,
    peak_force_environment_n: f64,
    peak_force_acting_n: f64,
    energy_into_port_mj: f64,
    stabilizer: Option<Stabilizer>,
}

/// What a stabilizer saw and did.
#[derive(Serialize)]
struct Stabilizer {
    observer_least_mj: f64,
    observer_most_mj: f64,
    observer_end_mj: f64,
    active_percent: f64,
    energy_asked_for_mj: f64,
    shortfall_mj: f64,
}

impl Summary {
    /// The summary of the scene called `scene`, as JSON; docs/command.md says what is in it.
    ///
    /// # Errors
    /// None: every part can be written as JSON, and a number that is not finite becomes null.
    pub fn to_json(&self, scene: &str) -> serde_json::Result<String> {
        let complete = self.left_range().is_none();
        let end = self.last.map_or(0.0, |row| row.t);
        let settling_time_s = self.settled.filter(|_| complete);
        let stabilizer = self.scene.stabilizer.is_some().then(|| self.stabilizer());
        let document = Document {
            scene,
            rows: self.rows,
            complete,
            settled: settling_time_s.is_some_and(|time| time <= LATE * end),
            settling_time_s,
            equilibrium_mm: self.equilibrium.map(|rest| MILLI * rest),
            band_mm: self.equilibrium.map(|_| MILLI * self.band),
            peak_force_environment_n: self.environment_peak,
            peak_force_acting_n: self.acting_peak,
            energy_into_port_mj: MILLI * self.absorbed,
            stabilizer,
        };
        serde_json::to_string_pretty(&document).map(|text| text + "\n")
    }

    fn stabilizer(&self) -> Stabilizer {
        Stabilizer {
            observer_least_mj: MILLI * self.observer_least,
            observer_most_mj: MILLI * self.observer_most,
            observer_end_mj: MILLI * self.last.map_or(0.0, |row| row.observer),
            active_percent: 100.0 * self.active as f64 / self.rows.max(1) as f64,
            energy_asked_for_mj: MILLI * self.injected,
            shortfall_mj: MILLI * self.shortfall,
        }
    }
}
