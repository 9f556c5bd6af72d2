//! What a drive tells when positions are measured otherwise.

use lyapunov_core::{Drive, Signal};

/// Drives with other positions in place of their own, from call to call.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Retold<V> {
    last: Option<V>,
}

impl<V: Signal> Retold<V> {
    pub(crate) fn new() -> Self {
        Self { last: None }
    }

    /// `drive` at `position`: with the displacement since the last one, 0 at first, and the work the acting effort's
    /// over that.
    #[inline(always)]
    pub(crate) fn drive(&mut self, drive: &Drive<V>, position: V) -> Drive<V> {
        let displacement = position - self.last.unwrap_or(position);
        self.last = Some(position);
        // What several periods under other efforts did is kept; of a single one this is exactly zero.
        let others = drive.work - drive.acted.times(drive.displacement);
        let work = drive.acted.times(displacement) + others;
        Drive { position, displacement, work, ..*drive }
    }
}
