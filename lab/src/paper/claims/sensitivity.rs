//! How the verdicts move with what the paper leaves open.

use lyapunov::ParameterError;

use super::ensemble::{Control, Setting, run};
use super::measures::{Measures, median};

/// What an ensemble comes to under one reading of the paper.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// The reading in words.
    pub name: String,
    /// The loop.
    pub setting: Setting,
    /// Share of the starts that stay bounded.
    pub bounded: f64,
    /// Share of the starts that settle.
    pub settled: f64,
    /// Median settling time of those, s.
    pub settling_time: Option<f64>,
    /// Median share of ticks on which the controller acts.
    pub active: f64,
    /// Median energy that the controller took, J.
    pub taken: f64,
}

/// Both walls under POPC and LOLC: caps from 0.25 to 1, servo rates from 100 Hz to 1 kHz, and the printed recursion.
///
/// # Errors
/// A number that no part takes.
pub fn sensitivity(starts: &[f64]) -> Result<Vec<Reading>, ParameterError> {
    let mut readings = Vec::new();
    for (stiffness, damping) in [(8e3, 2.0), (50e3, 20.0)] {
        for control in [Control::Popc, Control::Lolc] {
            let base = Setting::read(stiffness, damping, control);
            for cap in [0.25, 0.5, 0.75, 1.0] {
                readings.push(read(format!("cap {cap}"), Setting { cap, ..base }, starts)?);
            }
            for servo_rate in [200.0, 500.0, 1000.0] {
                let setting = Setting { servo_rate, ..base };
                readings.push(read(format!("observer at {servo_rate} Hz"), setting, starts)?);
            }
            let printed = Setting { printed: true, ..base };
            readings.push(read("printed recursion".to_owned(), printed, starts)?);
        }
    }
    Ok(readings)
}

fn read(name: String, setting: Setting, starts: &[f64]) -> Result<Reading, ParameterError> {
    let measures: Vec<Measures> = run(&setting, starts)?.iter().map(Measures::of).collect();
    let count = measures.len() as f64;
    let settled = || measures.iter().filter_map(|run| run.settled);
    Ok(Reading {
        name,
        setting,
        bounded: measures.iter().filter(|run| run.bounded).count() as f64 / count,
        settled: settled().count() as f64 / count,
        settling_time: median(settled()),
        active: median(measures.iter().map(|run| run.active)).unwrap_or(0.0),
        taken: median(measures.iter().map(|run| run.taken)).unwrap_or(0.0),
    })
}
