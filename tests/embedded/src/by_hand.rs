//! Passivity controller by hand, for comparison: no limit, and no check of what comes in.

use lyapunov_core::{Correction, PortSample, Scalar, Signal, Stabilizer};

/// Observed energy of the form by hand, J.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ByHand<T>(pub(crate) T);

impl<T: Scalar + Signal<Scalar = T>> Stabilizer<T> for ByHand<T> {
    fn stabilize(&mut self, sample: &PortSample<T>, effort: T) -> Correction<T> {
        let square = sample.velocity * sample.velocity * sample.period;
        self.0 += sample.work;
        let moving = square.above(T::smallest_normal());
        let alpha = T::choose(moving & self.0.below(T::zero()), -self.0 / square, T::zero());
        let told = Correction::none(effort + alpha * sample.velocity);
        Correction { observed_energy: self.0, alpha, ..told }
    }
}
