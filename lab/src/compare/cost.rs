//! What a step costs.

use std::hint::black_box;
use std::time::{Duration, Instant};

use lyapunov::{Action, Drive, ParameterError};

use super::contestants::Contestant;
use super::score::StepTime;
use crate::{Scene, Space};

/// How many ticks of a run are kept to be replayed: few enough to stay in the processor's cache.
pub(super) const KEPT: usize = 4096;

/// Rounds over all contestants.
const ROUNDS: usize = 31;

/// Steps that a round takes at least: long against one look at the clock.
const STEPS: usize = 1 << 15;

/// What stood before a stabilizer, tick by tick.
pub(super) type Samples<V> = Vec<(Drive<V>, V)>;

/// Times the step of every contestant over the samples of its own run.
///
/// The contestants take turns, round by round, so that a machine that slows down slows them all alike. A pass
/// over the samples starts with a fresh stabilizer; making it is not timed.
///
/// # Errors
/// What making a stabilizer may meet.
pub(super) fn of<V: Space>(
    scene: &Scene,
    contestants: &[Contestant<V>],
    samples: &[Samples<V>],
) -> Result<Vec<Option<StepTime>>, ParameterError> {
    let mut rounds = vec![Vec::with_capacity(ROUNDS); contestants.len()];
    // The round before the first warms up and does not count.
    for round in 0..=ROUNDS {
        for ((contestant, samples), times) in contestants.iter().zip(samples).zip(&mut rounds) {
            let passes = STEPS.div_ceil(samples.len().max(1));
            let elapsed = replay(scene, contestant, samples, passes)?;
            if round > 0 && !samples.is_empty() {
                times.push(elapsed.as_secs_f64() * 1e9 / (passes * samples.len()) as f64);
            }
        }
    }
    Ok(rounds.into_iter().map(spread).collect())
}

fn replay<V: Space>(
    scene: &Scene,
    contestant: &Contestant<V>,
    samples: &Samples<V>,
    passes: usize,
) -> Result<Duration, ParameterError> {
    let fresh = (0..passes).map(|_| contestant.stabilizer(scene));
    let mut stabilizers = fresh.collect::<Result<Vec<_>, _>>()?;
    let mut actions = vec![Action::none(V::zero()); samples.len()];
    let start = Instant::now();
    for stabilizer in &mut stabilizers {
        stabilizer.replay(black_box(samples), black_box(&mut actions));
    }
    Ok(start.elapsed())
}

fn spread(mut times: Vec<f64>) -> Option<StepTime> {
    times.sort_by(f64::total_cmp);
    let (&min, &max) = (times.first()?, times.last()?);
    let median = *times.get(times.len() / 2)?;
    Some(StepTime { median, min, max, rounds: times.len(), deterministic: false })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_spread_is_of_the_rounds() {
        let time = spread(vec![5.0, 1.0, 3.0, 9.0, 2.0]).unwrap();
        assert_eq!((time.min, time.median, time.max, time.rounds), (1.0, 3.0, 9.0, 5));
        assert!(!time.deterministic);
        assert_eq!(spread(Vec::new()), None);
    }
}
