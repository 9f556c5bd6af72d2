//! Integrators: one-step methods that solve a differential equation in time.

use crate::{Dynamics, Signal};

/// One-step method that solves `ẋ = f(x, u)` over an interval under a held input.
///
/// It returns the *gain* of the state, not the new state: a gain is a small number with digits of its own, and the
/// caller chooses how to sum it. Over an interval of 0 the gain is exactly 0. What an integrator keeps from step to
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
    /// The gain of the state `from` over `interval` s, while `input` is held.
    fn step(&mut self, dynamics: &D, from: D::State, input: U, interval: U::Scalar) -> D::State;
}

impl<U: Signal, D: Dynamics<U>, I: Integrator<U, D> + ?Sized> Integrator<U, D> for &mut I {
    #[inline]
    fn step(&mut self, dynamics: &D, from: D::State, input: U, interval: U::Scalar) -> D::State {
        (**self).step(dynamics, from, input, interval)
    }
}
