//! Velocity threshold: no correction near rest.

use lyapunov_core::{
    Correction, ParameterError, PortSample, Requirement, Scalar, Signal, Snapshot, Stabilizer,
};

use super::portion;
use crate::account::lends;

/// Stabilizer that corrects only where `|v|` is at least a threshold, m/s.
///
/// A debt at a small velocity requires a large damping, and where the velocity is mostly noise, so is its sign: the
/// correction then chatters. Hannaford and Ryu (IEEE Transactions on Robotics and Automation 18(1), 2002) see this in
/// their experiments. Below the threshold nothing is corrected, the whole debt is reported as shortfall, and it is
/// served once the motion is fast enough. Slower swings are left alone, so a loop may swing on where the stabilizer
/// alone settles it. Choose a threshold between one and two encoder counts over the period, as 1.5: the difference of
/// two positions may round to either side of one. 0 changes no bit.
///
/// ```
/// use lyapunov_core::{HeldTick, PortEnergy, Stabilizer};
/// use lyapunov_stabilizers::{DampingLimit, Popc, StabilizerExt};
/// let popc = Popc::new(PortEnergy, DampingLimit::of_mass(0.5, 0.2, 1e-3)?);
/// let mut popc = popc.above_velocity(0.05)?;
/// let slow = popc.stabilize(&HeldTick {
///     period: 1e-3, position: 0.0, velocity: 0.01, displacement: 1e-5, applied: -2.0
/// }.sample(), 0.0);
/// assert!(slow.alpha == 0.0 && slow.shortfall == 2e-5);
/// let fast = popc.stabilize(&HeldTick {
///     period: 1e-3, position: 0.0, velocity: 0.1, displacement: 1e-4, applied: 0.0
/// }.sample(), 0.0);
/// assert!(fast.alpha > 0.0 && fast.shortfall == 0.0);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct VelocityThreshold<S, T> {
    stabilizer: S,
    square: T,
}

impl<S, T: Scalar> VelocityThreshold<S, T> {
    pub(crate) fn new(stabilizer: S, velocity: T) -> Result<Self, ParameterError> {
        Ok(Self { stabilizer, square: squared(velocity)? })
    }
}

impl<V: Signal, S: Stabilizer<V>> Stabilizer<V> for VelocityThreshold<S, V::Scalar> {
    #[inline(always)]
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let correction = self.stabilizer.stabilize(sample, effort);
        let slow = sample.velocity.inner(sample.velocity).below(self.square);
        let share = V::Scalar::choose(slow, V::Scalar::of(0.0), V::Scalar::of(1.0));
        portion(correction, sample, effort, share)
    }
}

lends!(impl[S, T: Scalar] VelocityThreshold<S, T>, of S, in T);

impl<S, T: Scalar> VelocityThreshold<S, T> {
    /// The threshold, m/s.
    pub fn velocity(&self) -> T {
        self.square.sqrt()
    }

    /// Changes the threshold, m/s; a debt held back at the old one is served from the new one on.
    ///
    /// # Errors
    /// `velocity` below 0, not finite, or with a square out of range; the old one stays.
    pub fn set_velocity(&mut self, velocity: T) -> Result<(), ParameterError> {
        self.square = squared(velocity)?;
        Ok(())
    }
}

fn squared<T: Scalar>(velocity: T) -> Result<T, ParameterError> {
    let velocity = Requirement::NonNegative.check("velocity threshold", velocity)?;
    let square = velocity * velocity;
    // Below the normal numbers the root would not give the velocity back.
    let told = square.above(T::smallest_normal()) | !velocity.above(T::of(0.0));
    let in_range = square.finite() & told;
    Requirement::InRange.require("velocity threshold", velocity, in_range).map(|()| square)
}

lyapunov_core::snapshot! {
    impl[S: Snapshot, T: Scalar] VelocityThreshold<S, T>, is stabilizer, of S::State
}
