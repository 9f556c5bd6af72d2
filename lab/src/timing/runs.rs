//! Fresh runs of a loop against the clock.

use std::hint::black_box;
use std::time::{Duration, Instant};

use lyapunov::{ParameterError, Plant};

use crate::{Assembly, Scene, Space};

/// Fresh runs made at once at most, for they have room for long delays.
const MOST: u32 = 16;

/// How many runs take at least so `long`, if `one` takes that; no more than are made at once.
pub(crate) fn count_for(long: Duration, one: Duration) -> u32 {
    long.div_duration_f64(one).ceil().clamp(1.0, MOST.into()) as u32
}

/// The time that the loop of `scene` takes for `count` runs of so many `ticks`, which are made before.
///
/// # Errors
/// A parameter out of the range of the scalar.
pub(crate) fn runs<V: Space>(
    scene: &Scene,
    ticks: usize,
    count: u32,
) -> Result<Duration, ParameterError> {
    let fresh = (0..count).map(|_| Assembly::<V>::of(scene));
    let mut fresh = fresh.collect::<Result<Vec<_>, _>>()?;
    let start = Instant::now();
    for run in black_box(&mut fresh) {
        let mut sample = run.plant.start();
        for _ in 0..ticks {
            run.tick(&mut sample);
        }
        black_box(sample);
    }
    Ok(start.elapsed())
}
