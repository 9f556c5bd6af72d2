//! Backward-difference velocity.

use crate::{PortSample, Scalar, Signal, VelocityEstimator};

/// The backward difference, `v(n) = Δx(n) / T`: the mean velocity since the last sample.
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
