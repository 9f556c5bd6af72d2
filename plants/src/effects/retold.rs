//! Samples with other measured positions.

use lyapunov_core::{PortSample, Signal};

/// Samples with their positions replaced, from call to call.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Retold<V> {
    // Not an option: on lanes its copies are stored in pieces that the next load has to wait for.
    last: V,
    has_begun: bool,
}

impl<V: Signal> Retold<V> {
    /// Samples after one at the position `last`, or from the first on.
    pub(crate) fn after(last: Option<V>) -> Self {
        Self { last: last.unwrap_or_else(V::zero), has_begun: last.is_some() }
    }

    /// The last position, if there was one.
    pub(super) fn last(&self) -> Option<V> {
        self.has_begun.then_some(self.last)
    }

    /// `sample` at `position`: the displacement is that since the last position, 0 at first, and the work that of the
    /// applied effort over this displacement.
    #[inline(always)]
    pub(crate) fn sample(&mut self, sample: &PortSample<V>, position: V) -> PortSample<V> {
        let displacement = position - if self.has_begun { self.last } else { position };
        (self.last, self.has_begun) = (position, true);
        // Work of other efforts within several periods is kept; within a single one this is exactly zero.
        let others = sample.work - sample.applied.times(sample.displacement);
        let work = sample.applied.times(displacement) + others;
        PortSample { position, displacement, work, ..*sample }
    }
}
