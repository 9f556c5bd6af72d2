//! Result of a motion through one period.

use lyapunov_core::Scalar;

use super::series::System;
use super::trajectory::Trajectory;
use super::transition::{Transitions, set};

/// End of a motion through one period, in each lane.
pub(super) struct Passage<T, const S: usize> {
    /// The gain of each entry of the state.
    pub(super) gain: [T; S],
    /// The state at the end, of which the velocities are those of the motion: a device at rest has exactly 0.
    pub(super) velocity: [T; S],
    /// The energy that friction dissipated, J.
    pub(super) heat: T,
    pub(super) log: Transitions<T>,
    /// 1 where the motion reached the end of the period, else 0.
    complete: T,
}

impl<T: Scalar, const S: usize> Passage<T, S> {
    pub(super) fn none() -> Self {
        let (zero, log) = (T::zero(), Transitions::none());
        Self { gain: [zero; S], velocity: [zero; S], heat: zero, log, complete: zero }
    }

    /// The motion of the lanes `of` from `state` through `interval` s.
    #[inline(always)]
    pub(super) fn of(system: &System<T, S>, state: [T; S], interval: T, of: T::Mask) -> Self {
        let trajectory = Trajectory::run(system, state, interval, of);
        let complete = T::choose(trajectory.complete(), T::one(), T::zero());
        let mut velocity = state;
        for (index, velocity) in velocity.iter_mut().enumerate() {
            *velocity = trajectory.velocity(index);
        }
        let Trajectory { gain, heat, log, .. } = trajectory;
        Self { gain, velocity, heat, log, complete }
    }

    /// The lanes in which the motion reached the end of the period.
    #[inline(always)]
    pub(super) fn is_complete(&self) -> T::Mask {
        self.complete.above(T::zero())
    }

    /// Sets lane `lane` to a motion by itself.
    pub(super) fn set(&mut self, lane: usize, alone: &Passage<f64, S>) {
        for index in 0..S {
            set(&mut self.gain[index], lane, alone.gain[index]);
            set(&mut self.velocity[index], lane, alone.velocity[index]);
        }
        set(&mut self.heat, lane, alone.heat);
        set(&mut self.complete, lane, alone.complete);
        self.log.set(lane, &alone.log);
    }
}
