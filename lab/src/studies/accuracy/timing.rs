//! Timing of settings in turns.

use std::time::{Duration, Instant};

use lyapunov::ParameterError;

use super::AccuracyError;
use super::setting::{Number, Setting};
use super::trace::Progress;
use crate::files::Scene;
use crate::measure::timing::{Rounds, count_for, runs};
use crate::simulate::Instructions;

/// Rounds over all loops, at most and at least.
const ROUNDS: (f64, f64) = (31.0, 5.0);

/// The most time that all rounds together may take, s.
const PATIENCE: f64 = 12.0;

/// The least duration of the runs of a lap: long compared with one reading of the clock.
const WHILE: Duration = Duration::from_micros(100);

/// The most ticks of a run.
pub(super) const TICKS: usize = 2000;

/// Duration of something, ns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Time {
    /// The median over the rounds.
    pub median: f64,
    /// The distance from the lower quartile of the rounds to the upper one.
    pub spread: f64,
}

impl Time {
    pub(super) fn of(rounds: &Rounds, thing: usize) -> Self {
        let [lower, median, upper] = rounds.quartiles(thing);
        Self { median, spread: upper - lower }
    }
}

/// The time of each setting per simulated second of its scene, and the number of rounds.
pub(super) fn times(
    settings: &[(Setting, Scene)],
    ticks: usize,
    progress: Progress<'_>,
) -> Result<(Vec<Time>, usize), AccuracyError> {
    let ticks = ticks.min(TICKS);
    let mut counts = Vec::new();
    let warming = Instant::now();
    // The round before the first warms up, and shows how many runs are long enough.
    for (index, setting) in settings.iter().enumerate() {
        counts.push(count_for(WHILE, lap(setting, ticks, 1)?));
        progress.part(0.0, 0.1).tell(index, settings.len())?;
    }
    let round = warming.elapsed().as_secs_f64().max(WHILE.as_secs_f64() * settings.len() as f64);
    let rounds = (PATIENCE / round).clamp(ROUNDS.1, ROUNDS.0) as usize;
    let times = Rounds::of(settings.len(), rounds, |round, at| {
        let elapsed = lap(&settings[at], ticks, counts[at])?.as_secs_f64();
        let simulated = f64::from(counts[at]) * ticks as f64 * settings[at].1.period();
        progress.part(0.1, 1.0).tell(round * settings.len() + at, rounds * settings.len())?;
        Ok::<_, AccuracyError>(1e9 * elapsed / simulated)
    })?;
    Ok(((0..settings.len()).map(|at| Time::of(&times, at)).collect(), rounds))
}

/// The time of `count` runs of a setting.
fn lap(
    (setting, scene): &(Setting, Scene),
    ticks: usize,
    count: u32,
) -> Result<Duration, ParameterError> {
    match setting.number {
        Number::F64 => runs::<f64>(scene, Instructions::Base, ticks, count),
        Number::F32 | Number::F32WithWideLedger => {
            runs::<f32>(scene, Instructions::Base, ticks, count)
        }
    }
}
