//! What a sample tells when positions are measured otherwise.

use lyapunov_core::{PortSample, Signal};

/// Drives with other positions in place of their own, from call to call.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Retold<V> {
    last: Option<V>,
}

impl<V: Signal> Retold<V> {
    pub(crate) fn new() -> Self {
        Self { last: None }
    }

    /// `sample` at `position`: with the displacement since the last one, 0 at first, and the work the acting effort's
    /// over that.
    #[inline(always)]
    pub(crate) fn sample(&mut self, sample: &PortSample<V>, position: V) -> PortSample<V> {
        let displacement = position - self.last.unwrap_or(position);
        self.last = Some(position);
        // What several periods under other efforts did is kept; of a single one this is exactly zero.
        let others = sample.work - sample.applied.times(sample.displacement);
        let work = sample.applied.times(displacement) + others;
        PortSample { position, displacement, work, ..*sample }
    }
}
