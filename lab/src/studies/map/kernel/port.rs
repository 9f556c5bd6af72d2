//! The port of the kernel: a stabilized wall that is slower than the servo.

use lyapunov::{Correction, OnePort, PortSample, Stabilizer, environments::Wall};

use super::backward::{Fuse, Period};
use super::parts::Laned;

/// A wall that is asked on every `ticks`-th tick, a stabilizer before it, and velocities from the displacement over one
/// period.
///
/// The same bits as the wall [held](lyapunov::effects::ZeroOrderHold), stabilized and
/// [differenced](lyapunov::effects::BackwardDifference), without the work since the last answer, which no wall reads.
#[derive(Clone, Copy, Debug)]
pub(super) struct StabilizedWall<T, S> {
    wall: Wall<T>,
    stabilizer: S,
    period: Period<T>,
    ticks: u64,
    left: u64,
    answer: T,
}

impl<T: Fuse, S: Stabilizer<T>> StabilizedWall<T, S> {
    /// The port of `wall`, asked on every `ticks`-th tick from the first on.
    pub(super) fn new(wall: Wall<T>, ticks: u64, stabilizer: S, period: f64) -> Self {
        let (period, answer) = (Period::of(period), T::zero());
        Self { wall, stabilizer, period, ticks, left: 0, answer }
    }

    /// The force of the wall, held, N.
    #[inline(always)]
    pub(super) fn answer(&self) -> T {
        self.answer
    }

    #[inline(always)]
    pub(super) fn respond(&mut self, sample: &PortSample<T>) -> Correction<T> {
        let velocity = self.period.divide(sample.displacement);
        let seen = PortSample { velocity, ..*sample };
        if self.left == 0 {
            self.left = self.ticks;
            self.answer = self.wall.respond(&seen);
        }
        self.left -= 1;
        self.stabilizer.stabilize(&seen, self.answer)
    }
}

impl<T: Fuse, S: Laned<T>> StabilizedWall<T, S> {
    /// Forgets the force and the account of some `lanes`.
    pub(super) fn clear(&mut self, lanes: T::Mask) {
        self.answer = T::choose(lanes, T::zero(), self.answer);
        self.stabilizer = self.stabilizer.cleared(lanes);
    }
}
