//! Dynamics: the differential equation that an integrator solves.

use crate::Signal;

/// First-order differential equation under a held input: `ẋ = f(x, u)`.
///
/// It does not depend on time; a function of time acts through the input. A mechanical system states an acceleration
/// instead, as [`Mechanics`](crate::Mechanics), and gets its first-order form from there. A first-order lag is
///
/// ```
/// use lyapunov_core::Dynamics;
/// /// With a time constant of 0.1 s.
/// struct Lag;
/// impl Dynamics<f64> for Lag {
///     type State = f64;
///     fn rate(&self, state: f64, input: f64) -> f64 {
///         (input - state) / 0.1
///     }
/// }
/// ```
pub trait Dynamics<U: Signal> {
    /// The state: any [`Signal`], with one axis per number.
    type State: Signal<Scalar = U::Scalar>;

    /// The rate of change of `state` under `input`, per s.
    fn rate(&self, state: Self::State, input: U) -> Self::State;
}
