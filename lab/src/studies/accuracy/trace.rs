//! Runs of a loop with all digits of its scalar, and the progress of a study.

use std::ops::ControlFlow;

use lyapunov::{Plant, Scalar};

use super::AccuracyError;
use crate::simulate::{Assembly, Space};

/// Ticks between two calls of the watch.
const BREATH: usize = 4096;

/// Receiver of progress, which may end a study.
pub(super) type Watch<'a> = dyn Fn(f64) -> ControlFlow<()> + Sync + 'a;

/// The plant's true position and velocity at every tick, as long as both are finite.
pub(super) fn trace<T: Space + Scalar>(
    run: Assembly<T>,
    ticks: usize,
    progress: Progress<'_>,
) -> Result<Vec<[T::Real; 2]>, AccuracyError> {
    trace_until(run, ticks, progress, |_, _| false)
}

/// The same up to the first tick whose number and state are `enough`.
pub(super) fn trace_until<T: Space + Scalar>(
    mut run: Assembly<T>,
    ticks: usize,
    progress: Progress<'_>,
    mut enough: impl FnMut(usize, [T::Real; 2]) -> bool,
) -> Result<Vec<[T::Real; 2]>, AccuracyError> {
    let mut sample = run.plant.start();
    let mut trace = Vec::with_capacity(ticks);
    for tick in 0..ticks {
        if !(sample.position.lane(0).is_finite() && sample.velocity.lane(0).is_finite()) {
            break;
        }
        let state = [sample.position.real(0), sample.velocity.real(0)];
        trace.push(state);
        if enough(tick, state) {
            break;
        }
        run.tick(&mut sample);
        if tick % BREATH == 0 {
            progress.tell(tick, ticks)?;
        }
    }
    Ok(trace)
}

/// Part of the whole progress, reported to a watch.
#[derive(Clone, Copy)]
pub(super) struct Progress<'a> {
    watch: &'a Watch<'a>,
    from: f64,
    to: f64,
}

impl<'a> Progress<'a> {
    /// The whole progress.
    pub(super) fn new(watch: &'a Watch<'a>) -> Self {
        Self { watch, from: 0.0, to: 1.0 }
    }

    /// The part between two shares of this one.
    pub(super) fn part(self, from: f64, to: f64) -> Self {
        let at = |share| self.from + share * (self.to - self.from);
        Self { from: at(from), to: at(to), ..self }
    }

    /// Reports that `done` of `all` is done.
    ///
    /// # Errors
    /// [`AccuracyError::Stopped`] if the watch ends the study.
    pub(super) fn tell(self, done: usize, all: usize) -> Result<(), AccuracyError> {
        let share = done as f64 / all.max(1) as f64;
        match (self.watch)(self.part(share, share).from) {
            ControlFlow::Continue(()) => Ok(()),
            ControlFlow::Break(()) => Err(AccuracyError::Stopped),
        }
    }
}
