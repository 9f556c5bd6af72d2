//! The equation that an integrator follows.

use crate::Signal;

/// A first-order differential equation under an input that is held: `ẋ = f(x, u)`.
///
/// It does not depend on time: what follows time acts through the input. A mechanical system states an acceleration
/// instead, as [`Mechanics`](crate::Mechanics), and has its first-order form from there. A first-order lag is
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
    /// What changes: any [`Signal`], of as many axes as there are numbers.
    type State: Signal<Scalar = U::Scalar>;

    /// How fast `state` changes under `input`, per s.
    fn rate(&self, state: Self::State, input: U) -> Self::State;
}
