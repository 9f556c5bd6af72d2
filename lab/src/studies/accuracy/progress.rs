//! How far a study is.

use std::ops::ControlFlow;

use super::AccuracyError;

/// A part of the whole way, told to whoever watches.
#[derive(Clone, Copy)]
pub(super) struct Progress<'a> {
    watch: &'a dyn Fn(f64) -> ControlFlow<()>,
    from: f64,
    to: f64,
}

impl<'a> Progress<'a> {
    /// The whole way.
    pub(super) fn new(watch: &'a dyn Fn(f64) -> ControlFlow<()>) -> Self {
        Self { watch, from: 0.0, to: 1.0 }
    }

    /// The part between two shares of this one.
    pub(super) fn part(self, from: f64, to: f64) -> Self {
        let at = |share| self.from + share * (self.to - self.from);
        Self { from: at(from), to: at(to), ..self }
    }

    /// Tells that `done` of `all` is done.
    ///
    /// # Errors
    /// [`AccuracyError::Stopped`] if whoever watches ends it.
    pub(super) fn tell(self, done: usize, all: usize) -> Result<(), AccuracyError> {
        let share = done as f64 / all.max(1) as f64;
        match (self.watch)(self.part(share, share).from) {
            ControlFlow::Continue(()) => Ok(()),
            ControlFlow::Break(()) => Err(AccuracyError::Stopped),
        }
    }
}
