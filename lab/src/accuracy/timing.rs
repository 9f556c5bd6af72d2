//! Loops timed in turns.

use std::hint::black_box;
use std::time::{Duration, Instant};

use lyapunov::{ParameterError, Plant, Scalar};

use super::AccuracyError;
use super::progress::Progress;
use super::setting::{Number, Setting};
use crate::quartiles::quartiles;
use crate::{Assembly, Scene, Space};

/// Rounds over all loops, at most and at least.
const ROUNDS: (f64, f64) = (31.0, 5.0);

/// What all rounds together may take, s.
const PATIENCE: f64 = 12.0;

/// Runs of a lap take at least so long: long against one look at the clock.
const WHILE: Duration = Duration::from_micros(100);

/// Fresh runs made at once at most, for they have room for long delays.
const RUNS: u32 = 16;

/// Ticks of a run at most.
pub(super) const TICKS: usize = 2000;

/// How long something takes, ns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Time {
    /// The median over the rounds.
    pub median: f64,
    /// From the lower quartile of the rounds to the upper one.
    pub spread: f64,
}

impl Time {
    pub(super) fn of(rounds: Vec<f64>) -> Self {
        let [lower, median, upper] = quartiles(rounds);
        Self { median, spread: upper - lower }
    }
}

/// How long each setting takes for a simulated second of `scene`, timed in turns, round by round, so that a machine that
/// slows down slows them all alike; and the count of rounds.
pub(super) fn times(
    scene: &Scene,
    settings: &[Setting],
    ticks: usize,
    progress: Progress<'_>,
) -> Result<(Vec<Time>, usize), AccuracyError> {
    let scenes: Vec<Scene> = settings.iter().map(|setting| setting.put_on(scene)).collect();
    let ticks = ticks.min(TICKS);
    let mut counts = Vec::new();
    let warming = Instant::now();
    // The round before the first warms up, and tells how many runs are long enough.
    for (index, (setting, scene)) in settings.iter().zip(&scenes).enumerate() {
        let elapsed = lap(setting.number, scene, ticks, 1)?;
        let runs = WHILE.div_duration_f64(elapsed).ceil();
        counts.push(runs.clamp(1.0, RUNS.into()) as u32);
        progress.part(0.0, 0.1).tell(index, settings.len())?;
    }
    let round = warming.elapsed().as_secs_f64().max(WHILE.as_secs_f64() * settings.len() as f64);
    let rounds = (PATIENCE / round).clamp(ROUNDS.1, ROUNDS.0) as usize;
    let mut times = vec![Vec::with_capacity(rounds); settings.len()];
    for at in 0..rounds {
        for (index, (setting, scene)) in settings.iter().zip(&scenes).enumerate() {
            let elapsed = lap(setting.number, scene, ticks, counts[index])?.as_secs_f64();
            let simulated = f64::from(counts[index]) * ticks as f64 * scene.period();
            times[index].push(1e9 * elapsed / simulated);
            progress.part(0.1, 1.0).tell(at * settings.len() + index, rounds * settings.len())?;
        }
    }
    Ok((times.into_iter().map(Time::of).collect(), rounds))
}

fn lap(
    number: Number,
    scene: &Scene,
    ticks: usize,
    count: u32,
) -> Result<Duration, ParameterError> {
    match number {
        Number::F64 => runs::<f64>(scene, ticks, count),
        Number::F32 | Number::F32WithWideLedger => runs::<f32>(scene, ticks, count),
    }
}

/// The time of the loop alone, over `count` runs that are made before.
fn runs<T: Space + Scalar>(
    scene: &Scene,
    ticks: usize,
    count: u32,
) -> Result<Duration, ParameterError> {
    let fresh = (0..count).map(|_| Assembly::<T>::of(scene));
    let mut fresh = fresh.collect::<Result<Vec<_>, _>>()?;
    let start = Instant::now();
    for run in black_box(&mut fresh) {
        let mut drive = run.plant.start();
        for _ in 0..ticks {
            run.tick(&mut drive);
        }
        black_box(drive);
    }
    Ok(start.elapsed())
}
