//! The null stabilizer.

use lyapunov_core::{Correction, PortSample, Signal, Stabilizer};

use crate::StabilizerExt;

/// Null stabilizer: every effort passes unchanged, even one that is not finite.
///
/// ```text
/// f_out(n) = f_in(n), L(n) = 0, alpha(n) = 0
/// ```
///
/// It serves as the baseline of comparisons, and wherever the code needs a stabilizer and the loop does not. It
/// observes nothing, so it accepts every sample and keeps no law about rejection.
///
/// ```
/// use lyapunov_core::{HeldTick, Stabilizer};
/// use lyapunov_stabilizers::NoStabilizer;
/// let correction = NoStabilizer.stabilize(&HeldTick {
///     period: 1e-3, position: 0.0, velocity: 0.1, displacement: 1e-4, applied: 0.0
/// }.sample(), 5.0);
/// assert_eq!((correction.effort, correction.observed_energy, correction.alpha), (5.0, 0.0, 0.0));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct NoStabilizer;

impl<V: Signal> Stabilizer<V> for NoStabilizer {
    #[inline(always)]
    fn stabilize(&mut self, _sample: &PortSample<V>, effort: V) -> Correction<V> {
        Correction::none(effort)
    }
}

impl StabilizerExt for NoStabilizer {}

lyapunov_core::without_memory!(impl[] NoStabilizer);
