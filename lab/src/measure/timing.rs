//! Timing of things in turns, round by round, and of fresh runs of a loop.

use std::hint::black_box;
use std::time::{Duration, Instant};

use lyapunov::{ParameterError, Plant};
use pulp::NullaryFnOnce;

use super::quantile::quantile;
use crate::files::Scene;
use crate::simulate::{Assembly, Instructions, Scenes, Space};

/// Durations of several things, ns, by rounds.
#[derive(Debug)]
pub(crate) struct Rounds(Vec<Vec<f64>>);

impl Rounds {
    /// Times `things` in turns, round by round, so that a machine that slows down slows them all alike: `time` gets the
    /// round and the thing; there is at least one round.
    ///
    /// # Errors
    /// The first error of `time`.
    pub(crate) fn of<E>(
        things: usize,
        rounds: usize,
        mut time: impl FnMut(usize, usize) -> Result<f64, E>,
    ) -> Result<Self, E> {
        let mut times = vec![Vec::with_capacity(rounds); things];
        for round in 0..rounds {
            for (thing, times) in times.iter_mut().enumerate() {
                times.push(time(round, thing)?);
            }
        }
        Ok(Self(times))
    }

    /// Lower quartile, median and upper quartile of the rounds of `thing`.
    pub(crate) fn quartiles(&self, thing: usize) -> [f64; 3] {
        quartiles(&self.0[thing])
    }

    /// The fastest round of `thing`, and the slowest.
    pub(crate) fn extremes(&self, thing: usize) -> [f64; 2] {
        let times = self.0[thing].iter().copied();
        [times.clone().fold(f64::INFINITY, f64::min), times.fold(f64::NEG_INFINITY, f64::max)]
    }

    /// The quartiles of two things, compared round by round: a slow round slows both.
    pub(crate) fn compared(
        &self,
        one: usize,
        other: usize,
        by: impl Fn(f64, f64) -> f64,
    ) -> [f64; 3] {
        let pairs = self.0[one].iter().zip(&self.0[other]);
        quartiles(&pairs.map(|(one, other)| by(*one, *other)).collect::<Vec<_>>())
    }
}

/// Lower quartile, median and upper quartile of at least one value.
fn quartiles(values: &[f64]) -> [f64; 3] {
    [0.25, 0.5, 0.75].map(|share| quantile(values.iter().copied(), share).unwrap_or(f64::NAN))
}

/// The most fresh runs made at once: each has room for long delays.
const MOST: u32 = 16;

/// The number of runs that take at least `long`, if `one` is the time of one; at most as many as are made at once.
pub(crate) fn count_for(long: Duration, one: Duration) -> u32 {
    long.div_duration_f64(one).ceil().clamp(1.0, MOST.into()) as u32
}

/// The time that the loop of `scene` takes on `instructions` for `count` runs of `ticks` each; making the runs is not
/// timed.
///
/// # Errors
/// A parameter out of the range of the scalar.
pub(crate) fn runs<V: Space>(
    scene: &Scene,
    instructions: Instructions,
    ticks: usize,
    count: u32,
) -> Result<Duration, ParameterError> {
    let scenes = Scenes::on(std::slice::from_ref(scene), instructions);
    let fresh = (0..count).map(|_| Assembly::<V>::on(scenes));
    let mut fresh = fresh.collect::<Result<Vec<_>, _>>()?;
    let start = Instant::now();
    V::run(instructions, Fresh { runs: &mut fresh, ticks });
    Ok(start.elapsed())
}

/// Fresh runs, to be run over some ticks.
struct Fresh<'a, V: Space> {
    runs: &'a mut [Assembly<V>],
    ticks: usize,
}

impl<V: Space> NullaryFnOnce for Fresh<'_, V> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        for run in black_box(self.runs) {
            let mut sample = run.plant.start();
            for _ in 0..self.ticks {
                run.tick(&mut sample);
            }
            black_box(sample);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn things_are_compared_round_by_round() {
        // A machine that is three times as slow from the third round on.
        let times = [[10.0, 10.0, 30.0, 30.0, 30.0], [15.0, 16.0, 45.0, 45.0, 45.0]];
        let mut order = Vec::new();
        let rounds = Rounds::of(2, 5, |round, thing| {
            order.push((round, thing));
            Ok::<_, ()>(times[thing][round])
        });
        let rounds = rounds.unwrap();
        assert_eq!(order[..4], [(0, 0), (0, 1), (1, 0), (1, 1)]);
        assert_eq!(rounds.compared(1, 0, |with, without| with - without), [6.0, 15.0, 15.0]);
        assert_eq!(rounds.compared(1, 0, |with, without| with / without)[1], 1.5);
        assert_eq!((rounds.quartiles(1), rounds.extremes(1)), ([16.0, 45.0, 45.0], [15.0, 45.0]));
        assert_eq!(Rounds::of(1, 3, |_, _| Err(7)).unwrap_err(), 7);
    }
}
