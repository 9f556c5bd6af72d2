//! Required decay of a Lyapunov function, as a term of a candidate.

use lyapunov_core::{
    LyapunovCandidate, LyapunovFunction, ParameterError, PortSample, Requirement, Scalar,
};
use nalgebra::SVector;

use crate::WithState;

/// The debit `c V(x) T`: together with [`decrease_of`](crate::decrease_of) it requires `V` not only to stay below its
/// initial value but to decay at the rate `c`, 1/s.
///
/// The sum of both is `L(n) = V(0) − V(n) − c Σ V T`. While `L ≥ 0`, `V` is not above `V(0)`, and the integral of `V`
/// is not above `V(0) / c` however long the loop runs: so `V` goes to 0. If something holds the plant away from rest
/// for good, such as a load, no damping can serve this debt and it grows; leave the term out there. More damping is not
/// always faster: far above critical damping a plant creeps, `V` falls more slowly than required, and the growing debt
/// keeps the damping where it is. With this term, a limit near critical damping is the better one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Decay<F, T> {
    function: F,
    rate: T,
}

impl<F, T: Scalar> Decay<F, T> {
    /// The decay of `function` at `rate`, 1/s.
    ///
    /// # Errors
    /// `rate` below 0, infinite or NaN.
    pub fn new(function: F, rate: T) -> Result<Self, ParameterError> {
        Ok(Self { function, rate: Requirement::NonNegative.check("rate", rate)? })
    }
}

lyapunov_core::without_memory!(impl[F, T: Scalar] Decay<F, T>);

impl<T, F, const N: usize, const M: usize> LyapunovCandidate<WithState<T, N, M>> for Decay<F, T>
where
    T: Scalar,
    F: LyapunovFunction<SVector<T, N>>,
{
    #[inline]
    fn decrease(&mut self, sample: &PortSample<WithState<T, N, M>>) -> T {
        -(self.rate * self.function.value(sample.position.state) * sample.period)
    }
}
