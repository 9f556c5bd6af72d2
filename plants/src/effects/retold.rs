//! Samples with other measured positions.

use lyapunov_core::{PortSample, Signal};

/// Samples with their positions replaced, from call to call.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Retold<V> {
    pub(super) last: Option<V>,
}

impl<V: Signal> Retold<V> {
    pub(crate) fn new() -> Self {
        Self { last: None }
    }

    /// `sample` at `position`: the displacement is that since the last position, 0 at first, and the work that of the
    /// applied effort over this displacement.
    #[inline(always)]
    pub(crate) fn sample(&mut self, sample: &PortSample<V>, position: V) -> PortSample<V> {
        let displacement = position - self.last.unwrap_or(position);
        self.last = Some(position);
        // Work of other efforts within several periods is kept; within a single one this is exactly zero.
        let others = sample.work - sample.applied.times(sample.displacement);
        let work = sample.applied.times(displacement) + others;
        PortSample { position, displacement, work, ..*sample }
    }
}
