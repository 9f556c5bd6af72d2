//! What follows a differential equation through time.

use crate::{Dynamics, Signal};

/// A one-step method: it follows `ẋ = f(x, u)` over an interval under a held input.
///
/// It answers with what the state *gains*, not with the new state: a gain is a small number with digits of its own,
/// and whoever sums chooses how. Over no time it gains exactly nothing. What an integrator remembers from step to
/// step (a matrix, a step size) is in its value.
///
/// ```
/// use lyapunov_core::{Dynamics, Integrator, Signal};
/// /// Euler's method, of order 1.
/// struct Euler;
/// impl<U: Signal, D: Dynamics<U>> Integrator<U, D> for Euler {
///     fn step(&mut self, dynamics: &D, from: D::State, input: U, interval: U::Scalar) -> D::State {
///         dynamics.rate(from, input).scale(interval)
///     }
/// }
/// ```
pub trait Integrator<U: Signal, D: Dynamics<U>> {
    /// What `from` gains over `interval` s, while `input` is held.
    fn step(&mut self, dynamics: &D, from: D::State, input: U, interval: U::Scalar) -> D::State;
}

impl<U: Signal, D: Dynamics<U>, I: Integrator<U, D> + ?Sized> Integrator<U, D> for &mut I {
    #[inline]
    fn step(&mut self, dynamics: &D, from: D::State, input: U, interval: U::Scalar) -> D::State {
        (**self).step(dynamics, from, input, interval)
    }
}
