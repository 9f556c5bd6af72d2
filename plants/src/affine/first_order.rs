//! A first-order equation as one of motion.

use lyapunov_core::{Dynamics, LyapunovFunction, Scalar};
use nalgebra::SVector;

use crate::{ControlAffine, WithState};

/// A control-affine plant as [`Dynamics`], so that every [`Integrator`](lyapunov_core::Integrator) moves it.
///
/// The state stands where velocities do, and the integral of the flow beside it: `ẋ = f(x) − g(x) e` and
/// `ẇ = y = L_g V`. The positions are the integrals of both and nothing looks at them. With
/// [`RungeKutta4`](crate::RungeKutta4) this is the classical method for `(w, x)`, so that `Δw` is good to order 4 as
/// `x` is. The semi-implicit Euler method is the explicit one here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FirstOrder<P, F> {
    /// What moves.
    pub plant: P,
    /// The function whose derivative along the inputs is the flow.
    pub function: F,
}

impl<T, P, F, const N: usize, const M: usize> Dynamics<WithState<T, N, M>> for FirstOrder<P, F>
where
    T: Scalar,
    P: ControlAffine<T, N, M>,
    F: LyapunovFunction<SVector<T, N>>,
{
    type Coordinates = WithState<T, N, M>;

    #[inline]
    fn acceleration(
        &self,
        _position: WithState<T, N, M>,
        velocity: WithState<T, N, M>,
        effort: WithState<T, N, M>,
    ) -> WithState<T, N, M> {
        let state = velocity.state;
        WithState {
            input: self.plant.flow(&self.function, state),
            state: self.plant.rate(state, -effort.input),
        }
    }
}
