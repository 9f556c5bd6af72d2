//! Loops timed in turns.

use std::hint::black_box;
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use lyapunov::{ParameterError, Plant, Scalar};
use nalgebra::SVector;

use super::calls::Call;
use super::{Difference, PricesError};
use crate::quartiles::quartiles;
use crate::{Assembly, Scene, Space};

/// Rounds over all loops.
pub(super) const ROUNDS: usize = 41;

/// Ticks of a run: the way to the wall and the first contact.
pub(super) const TICKS: usize = 250;

/// Runs of a round take at least so long: long against one look at the clock.
const WHILE: Duration = Duration::from_micros(200);

/// Fresh runs made at once at most, for they have room for long delays.
const RUNS: u32 = 16;

/// Runs that a loop is taken through, and how long they take.
type Lap = fn(&Scene, u32) -> Result<Duration, ParameterError>;

/// How the loop of `call` is timed in the scalar `T`.
fn lap<T: Space + Scalar>(call: &Call) -> Lap {
    match call.scene.dimensions() {
        3 => runs::<SVector<T, 3>>,
        2 => runs::<SVector<T, 2>>,
        _ => runs::<T>,
    }
}

fn runs<V: Space>(scene: &Scene, count: u32) -> Result<Duration, ParameterError> {
    let fresh = (0..count).map(|_| Assembly::<V>::of(scene));
    let mut fresh = fresh.collect::<Result<Vec<_>, _>>()?;
    let start = Instant::now();
    for run in black_box(&mut fresh) {
        let mut drive = run.plant.start();
        for _ in 0..TICKS {
            run.tick(&mut drive);
        }
        black_box(drive);
    }
    Ok(start.elapsed())
}

/// The time of a step of every loop, ns, by rounds.
#[derive(Debug)]
pub(super) struct Times(Vec<Vec<f64>>);

/// Times all loops in turns, round by round, so that a machine that slows down slows them all alike.
pub(super) fn times<T: Space + Scalar>(
    calls: &[Call],
    watch: &dyn Fn() -> ControlFlow<()>,
) -> Result<Times, PricesError> {
    let mut counts = vec![1; calls.len()];
    let mut times = vec![Vec::with_capacity(ROUNDS); calls.len()];
    // The round before the first warms up, and tells how many runs are long enough.
    for round in 0..=ROUNDS {
        for ((call, count), times) in calls.iter().zip(&mut counts).zip(&mut times) {
            let elapsed = lap::<T>(call)(&call.scene, *count)?;
            if round == 0 {
                *count = WHILE.div_duration_f64(elapsed).ceil().clamp(1.0, RUNS.into()) as u32;
            } else {
                times.push(elapsed.as_secs_f64() * 1e9 / (*count as usize * TICKS) as f64);
            }
            if watch().is_break() {
                return Err(PricesError::Stopped);
            }
        }
    }
    Ok(Times(times))
}

impl Times {
    pub(super) fn median(&self, at: usize) -> f64 {
        quartiles(self.0[at].clone())[1]
    }

    /// Compared round by round: what slows one round slows both loops in it.
    pub(super) fn difference(&self, without: usize, with: usize) -> Difference {
        let rounds = || self.0[without].iter().zip(&self.0[with]);
        let [lower, median, upper] = quartiles(rounds().map(|(b, a)| a - b).collect());
        let [_, ratio, _] = quartiles(rounds().map(|(b, a)| a / b).collect());
        Difference { ns_per_step: median, spread_ns: upper - lower, ratio }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn loops_are_compared_round_by_round() {
        // A machine that is three times as slow from the third round on.
        let times =
            Times(vec![vec![10.0, 10.0, 30.0, 30.0, 30.0], vec![15.0, 16.0, 45.0, 45.0, 45.0]]);
        let difference = times.difference(0, 1);
        assert_eq!((difference.ns_per_step, difference.spread_ns), (15.0, 9.0));
        assert_eq!(difference.ratio, 1.5);
        assert_eq!(times.median(1), 45.0);
    }
}
