//! Wall with an oscillating surface.

use lyapunov_core::{LyapunovCandidate, OnePort, ParameterError, PortSample, Scalar, Snapshot};

use crate::environments::oscillation::Oscillation;
use crate::{DissipationOf, ForceLaw, Kinematics, Surface, Time, Wall};

/// A [`Wall`] whose surface oscillates about its position: at `position + amplitude sin(2π frequency t(n))`, with the
/// velocity `2π frequency amplitude cos(2π frequency t(n))`.
///
/// Penetration and velocity are relative to the surface: `f = max(0, k p + b (v − v_surface))` for `p > 0`, else 0. A
/// moving wall does work of its own and may feed energy to the port without any sampling error.
///
/// `t(n) = n / rate`, with `n` the earlier calls of this environment, none at the first. Time is never summed: the
/// phase is `2π · (frequency · (n / rate))` in `f64`, whatever the scalar. An adaptor that keeps calls from the wall
/// keeps it from moving.
///
/// An amplitude of 0 is the wall at rest, to the last bit.
///
/// ```
/// use lyapunov_core::{PortSample, OnePort};
/// use lyapunov_plants::{MovingWall, Wall};
/// // Asked every 10 ms, it swings once in 40 ms: it stands at 0, 2, 0 and −2 mm.
/// let mut wall = MovingWall::new(Wall::new(1000.0_f64, 0.0)?, 0.002, 25.0, 100.0)?;
/// let still = PortSample::starting(0.01, 0.001, 0.0);
/// for force in [1.0, 0.0, 1.0, 3.0] {
///     assert!((wall.respond(&still) - force).abs() < 1e-12);
/// }
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MovingWall<T> {
    wall: Wall<T>,
    motion: Oscillation<T>,
}

impl<T: Scalar> MovingWall<T> {
    /// `wall`, oscillating by `amplitude` m at `frequency` Hz, called `rate` times in a second.
    ///
    /// # Errors
    /// `amplitude` infinite or NaN; `frequency` below 0, infinite or NaN; `rate` not above 0 and finite; a
    /// frequency so high that speed or phase are out of range.
    pub fn new(wall: Wall<T>, amplitude: T, frequency: T, rate: T) -> Result<Self, ParameterError> {
        Ok(Self { wall, motion: Oscillation::new(amplitude, frequency, rate)? })
    }

    /// The credit of the wall's own damper, `b (v − v_surface)² T` strictly beyond the moving surface, for an observer
    /// that is called `rate` times in a second from the wall's first call on.
    ///
    /// The damper dissipates in part the work that moves the wall: this credits something even while the hand rests.
    ///
    /// # Errors
    /// Those of [`new`](Self::new).
    pub fn dissipation(&self, rate: T) -> Result<DissipationOf<Self>, ParameterError> {
        Ok(DissipationOf(Self { wall: self.wall, motion: self.motion.called_at(rate)? }))
    }

    /// The wall in its place at the time of a motion, and that motion relative to its surface.
    #[inline]
    fn seen_from_surface(&self, motion: &Kinematics<T>) -> (Wall<T>, Kinematics<T>) {
        let wall = self.wall.shifted(self.motion.value(motion.time));
        let velocity = motion.velocity - self.motion.slope(motion.time);
        (wall, Kinematics { velocity, ..*motion })
    }
}

impl<T: Scalar> ForceLaw<T> for MovingWall<T> {
    #[inline(always)]
    fn force(&self, motion: &Kinematics<T>) -> T {
        let (wall, relative) = self.seen_from_surface(motion);
        wall.force(&relative)
    }

    fn stored(&self, motion: &Kinematics<T>) -> T {
        let (wall, relative) = self.seen_from_surface(motion);
        wall.stored(&relative)
    }

    fn surface(&self, time: Time<T>) -> Option<Surface<T>> {
        let velocity = self.motion.slope(time);
        let stands = self.wall.shifted(self.motion.value(time)).surface(time);
        stands.map(|surface| Surface { velocity, ..surface })
    }
}

impl<T: Scalar> OnePort<T> for MovingWall<T> {
    #[inline(always)]
    fn respond(&mut self, sample: &PortSample<T>) -> T {
        let time = self.motion.tick();
        self.force(&Kinematics { time, ..Kinematics::of(sample) })
    }
}

impl<T: Scalar> LyapunovCandidate<T> for DissipationOf<MovingWall<T>> {
    #[inline(always)]
    fn decrease(&mut self, sample: &PortSample<T>) -> T {
        let Self(moving) = self;
        let time = moving.motion.tick();
        let now = Kinematics { time, ..Kinematics::of(sample) };
        let (wall, Kinematics { velocity, .. }) = moving.seen_from_surface(&now);
        wall.dissipation().decrease(&PortSample { velocity, ..*sample })
    }
}

impl<T: Scalar> Snapshot for MovingWall<T> {
    /// The number of calls, which is its time.
    type State = u64;

    fn state(&self) -> u64 {
        self.motion.calls()
    }

    fn restored(self, calls: u64) -> Result<Self, ParameterError> {
        Ok(Self { motion: self.motion.after(calls), ..self })
    }
}
