//! Equation of a control-affine plant and of the flow at its port.

use lyapunov_core::{Dynamics, LyapunovFunction, Scalar};
use nalgebra::SVector;

use crate::{ControlAffine, WithState};

/// A control-affine plant of `N` states with the integral `w` of its flow, under the effort `e = −u`:
/// `ẋ = f(x) − g(x) e` and `ẇ = y = L_g V`.
///
/// One integrator moves both, so `Δw` is accurate to the same order as `x`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WithFlow<P, F, const N: usize> {
    /// The plant.
    pub plant: P,
    /// The function whose derivative along the inputs is the flow.
    pub function: F,
}

impl<T, P, F, const N: usize, const M: usize> Dynamics<SVector<T, M>> for WithFlow<P, F, N>
where
    T: Scalar,
    P: ControlAffine<T, N, M>,
    F: LyapunovFunction<SVector<T, N>>,
{
    /// `w` as the input part, `x` as the state part.
    type State = WithState<T, N, M>;

    #[inline]
    fn rate(&self, at: Self::State, effort: SVector<T, M>) -> Self::State {
        WithState {
            input: self.plant.flow(&self.function, at.state),
            state: self.plant.rate(at.state, -effort),
        }
    }
}
