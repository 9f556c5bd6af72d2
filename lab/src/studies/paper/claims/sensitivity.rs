//! Sensitivity of the verdicts to what the paper leaves open.

use lyapunov::ParameterError;

use super::ensemble::{Control, Setting};
use super::measures::{Measures, median};
use super::rows::{Claim, Loops, measured};

/// Result of an ensemble under one reading of the paper.
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
    /// Median settling time of the starts that settle, s.
    pub settling_time: Option<f64>,
    /// Median share of ticks on which the controller acts.
    pub active: f64,
    /// Median energy taken by the controller, J.
    pub taken: f64,
}

/// The claims about the two walls under one reading.
#[derive(Clone, Debug, PartialEq)]
pub struct MovedClaim {
    /// The reading in words.
    pub name: String,
    /// The claims, in the order of [`claims`](super::claims).
    pub claims: Vec<Claim>,
}

/// Ensembles and verdicts under other readings: caps from 0.25 to 1, servo rates from 100 Hz to 1 kHz, and the
/// printed recursion.
///
/// # Errors
/// A number that a part rejects.
pub fn sensitivity(starts: &[f64]) -> Result<(Vec<Reading>, Vec<MovedClaim>), ParameterError> {
    let (mut readings, mut moved) = (Vec::new(), Vec::new());
    for (name, change) in changes() {
        let loops = Loops::of(starts, &change)?;
        let soft = |control| change(Setting::read(8e3, 2.0, control));
        let stiff = |control| change(Setting::read(50e3, 20.0, control));
        let popc8k = measured(soft(Control::Popc), starts)?;
        readings.push(read(&name, soft(Control::Popc), &popc8k));
        readings.push(read(&name, soft(Control::Lolc), &loops.lolc8k));
        readings.push(read(&name, stiff(Control::Popc), &loops.popc50k));
        readings.push(read(&name, stiff(Control::Lolc), &loops.lolc50k));
        moved.push(MovedClaim { name, claims: loops.claims() });
    }
    // Sorted by wall and stabilizer.
    readings.sort_by(|one, other| {
        let key = |reading: &Reading| (reading.setting.stiffness, reading.setting.control as u8);
        key(one).partial_cmp(&key(other)).unwrap_or(std::cmp::Ordering::Equal)
    });
    Ok((readings, moved))
}

type Change = Box<dyn Fn(Setting) -> Setting>;

fn changes() -> Vec<(String, Change)> {
    let mut changes: Vec<(String, Change)> = Vec::new();
    for cap in [0.25, 0.5, 0.75, 1.0] {
        changes.push((format!("cap {cap}"), Box::new(move |base| Setting { cap, ..base })));
    }
    for servo_rate in [200.0, 500.0, 1000.0] {
        let name = format!("observer at {servo_rate} Hz");
        changes.push((name, Box::new(move |base| Setting { servo_rate, ..base })));
    }
    let printed = |base| Setting { printed: true, ..base };
    changes.push(("printed recursion".to_owned(), Box::new(printed)));
    changes
}

fn read(name: &str, setting: Setting, measures: &[Measures]) -> Reading {
    let count = measures.len() as f64;
    let settled = || measures.iter().filter_map(|run| run.settled);
    Reading {
        name: name.to_owned(),
        setting,
        bounded: measures.iter().filter(|run| run.bounded).count() as f64 / count,
        settled: settled().count() as f64 / count,
        settling_time: median(settled()),
        active: median(measures.iter().map(|run| run.active)).unwrap_or(0.0),
        taken: median(measures.iter().map(|run| run.taken)).unwrap_or(0.0),
    }
}
