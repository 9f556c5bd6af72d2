//! The port of the kernel: a stabilized wall that is slower than the servo.

use lyapunov::{Correction, Mask, OnePort, PortSample, Stabilizer, environments::Wall};

use super::backward::{Fuse, Period};
use super::parts::{Accounted, Crediting, Laned};
use super::sure::{LARGE, MODERATE, SurePort};

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
    /// The wall's position where all numbers of the wall are moderate, m.
    surface: Option<T>,
    /// The observed energy after ticks without checks, which the stabilizer does not have yet.
    ahead: Option<T>,
}

impl<T: Fuse, S: Stabilizer<T>> StabilizedWall<T, S> {
    /// The port of `wall`, asked on every `ticks`-th tick from the first on.
    pub(super) fn new(wall: Wall<T>, ticks: u64, stabilizer: S, period: f64) -> Self {
        let (period, answer) = (Period::of(period), T::zero());
        Self { wall, stabilizer, period, ticks, left: 0, answer, surface: None, ahead: None }
    }

    /// The same, with a wall at `surface` all of whose numbers are moderate.
    pub(super) fn sure(self, surface: T) -> Self {
        Self { surface: Some(surface), ..self }
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

impl<T: Fuse, S: Accounted<T>> StabilizedWall<T, S> {
    /// The port for ticks without checks; none where it has no such ticks.
    #[inline(always)]
    pub(super) fn unchecked(&self, sample: &PortSample<T>) -> Option<SurePort<T, S::Candidate>> {
        let Self { wall, period, ticks, left, answer, .. } = *self;
        let (mut account, surface) = (self.stabilizer.account()?, self.surface?);
        if let Some(energy) = self.ahead {
            account.energy = energy;
        }
        // What an earlier tick brings into these.
        let [most, large] = [MODERATE, LARGE].map(T::of);
        let is_moderate = account.most.below(most)
            & account.candidate.damping().below(most)
            & sample.displacement.magnitude().below(most)
            & answer.magnitude().below(large);
        let port =
            SurePort { wall, period, ticks, left, answer, account, surface, least: T::largest() };
        is_moderate.all().then_some(port)
    }

    /// Goes on after `port`.
    #[inline(always)]
    pub(super) fn follow(&mut self, port: &SurePort<T, S::Candidate>) {
        (self.left, self.answer) = (port.left, port.answer);
        // To tell a stabilizer takes as long as some ticks, so it is told when it is asked.
        self.ahead = Some(port.account.energy);
    }

    #[cfg(test)]
    pub(super) fn stabilizer(&self) -> &S {
        &self.stabilizer
    }

    /// The observed energy after ticks without checks, J; none after others.
    pub(super) fn ahead(&self) -> Option<T> {
        self.ahead
    }

    /// Tells the stabilizer what it missed.
    #[inline(always)]
    pub(super) fn catch_up(&mut self) {
        if let Some(energy) = self.ahead.take() {
            self.stabilizer = self.stabilizer.observing(energy);
        }
    }
}

impl<T: Fuse, S: Laned<T>> StabilizedWall<T, S> {
    /// Forgets the force and the account of some `lanes`.
    pub(super) fn clear(&mut self, lanes: T::Mask) {
        self.catch_up();
        self.answer = T::choose(lanes, T::zero(), self.answer);
        self.stabilizer = self.stabilizer.cleared(lanes);
    }
}
