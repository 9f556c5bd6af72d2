//! Backward-difference velocity.

use crate::{PortSample, Scalar, Signal, VelocityEstimator};

/// The backward difference, `v(n) = Δx(n) / T`: the mean velocity since the last sample.
///
/// ```
/// use lyapunov_core::{Differenced, HeldTick, VelocityEstimator};
/// let tick = HeldTick { period: 0.5, position: 3.0, velocity: 0.0, displacement: 1.0, applied: 0.0 };
/// assert_eq!(Differenced.velocity(&tick.sample()), 2.0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Differenced;

impl<V: Signal> VelocityEstimator<V> for Differenced {
    #[inline(always)]
    fn velocity(&mut self, sample: &PortSample<V>) -> V {
        sample.displacement.map(|moved| moved / sample.period)
    }

    #[inline(always)]
    fn restart(&mut self, _lanes: <V::Scalar as Scalar>::Mask) {}
}
