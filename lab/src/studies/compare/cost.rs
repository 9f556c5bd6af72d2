//! Cost of a step.

use std::hint::black_box;
use std::time::{Duration, Instant};

use lyapunov::{Correction, ParameterError, PortSample};

use super::compared::RunError;
use super::entrant_run::Watch;
use super::entrants::Entrant;
use super::score::StepTime;
use crate::files::Scene;
use crate::measure::timing::Rounds;
use crate::simulate::Space;

/// The number of ticks of a run that are kept for replay: few enough to stay in the processor's cache.
pub(super) const KEPT: usize = 4096;

/// Rounds over all entrants.
const ROUNDS: usize = 31;

/// The least number of steps in a round: long compared with one reading of the clock.
const STEPS: usize = 1 << 15;

/// The time from which on a round may have fewer steps: those of a stabilizer that an interpreter runs, or of a run so short that most
/// of the time goes into making stabilizers.
const LONG: Duration = Duration::from_millis(3);

/// The samples and efforts that a stabilizer got, tick by tick.
pub(super) type Samples<V> = Vec<(PortSample<V>, V)>;

/// Times the step of every entrant over the samples of its own run.
///
/// A pass over the samples starts with a fresh stabilizer; making it is not timed.
///
/// # Errors
/// A stabilizer that cannot be made; [`RunError::Stopped`] if `watch` says so.
pub(super) fn of<V: Space>(
    scene: &Scene,
    entrants: &[Entrant<V>],
    samples: &[Samples<V>],
    watch: &Watch<'_>,
) -> Result<Vec<Option<StepTime>>, RunError> {
    // One pass before the rounds warms up, and tells how many make a round.
    let passes = entrants.iter().zip(samples).map(|(entrant, samples)| {
        let start = Instant::now();
        replay(scene, entrant, samples, 1)?;
        let one = start.elapsed().max(Duration::from_nanos(1));
        let enough = LONG.div_duration_f64(one).ceil() as usize;
        Ok(STEPS.div_ceil(samples.len().max(1)).min(enough))
    });
    let passes = passes.collect::<Result<Vec<_>, ParameterError>>()?;
    let times = Rounds::of(entrants.len(), ROUNDS, |_, at| {
        if watch(0).is_break() {
            return Err(RunError::Stopped);
        }
        let (samples, passes) = (&samples[at], passes[at]);
        let elapsed = replay(scene, &entrants[at], samples, passes)?;
        Ok(elapsed.as_secs_f64() * 1e9 / (passes * samples.len()) as f64)
    })?;
    let told = samples.iter().enumerate().map(|(at, samples)| {
        let ([_, median, _], [min, max]) = (times.quartiles(at), times.extremes(at));
        let time = StepTime { median, min, max, rounds: ROUNDS, deterministic: false };
        (!samples.is_empty()).then_some(time)
    });
    Ok(told.collect())
}

fn replay<V: Space>(
    scene: &Scene,
    entrant: &Entrant<V>,
    samples: &Samples<V>,
    passes: usize,
) -> Result<Duration, ParameterError> {
    let fresh = (0..passes).map(|_| entrant.fitted(scene));
    let mut stabilizers = fresh.collect::<Result<Vec<_>, _>>()?;
    let mut corrections = vec![Correction::none(V::zero()); samples.len()];
    let start = Instant::now();
    for stabilizer in &mut stabilizers {
        stabilizer.replay(black_box(samples), black_box(&mut corrections))?;
    }
    Ok(start.elapsed())
}
