//! Where a loop goes, with all digits of its scalar.

use lyapunov::{Plant, Scalar};

use super::AccuracyError;
use super::progress::Progress;
use crate::simulate::building::{Assembly, Space};

/// Ticks from one look at the watch to the next.
const BREATH: usize = 4096;

/// The plant's true position and velocity at every tick, as far as both are finite.
pub(super) fn trace<T: Space + Scalar>(
    mut run: Assembly<T>,
    ticks: usize,
    progress: Progress<'_>,
) -> Result<Vec<[T::Real; 2]>, AccuracyError> {
    let mut sample = run.plant.start();
    let mut trace = Vec::with_capacity(ticks);
    for tick in 0..ticks {
        if !(sample.position.lane(0).is_finite() && sample.velocity.lane(0).is_finite()) {
            break;
        }
        trace.push([sample.position.real(0), sample.velocity.real(0)]);
        run.tick(&mut sample);
        if tick % BREATH == 0 {
            progress.tell(tick, ticks)?;
        }
    }
    Ok(trace)
}
