//! Classical Runge-Kutta method, order 4.

use lyapunov_core::{Dynamics, Integrator, Scalar, Signal};

/// The classical Runge-Kutta method (Kutta 1901), for `ẋ = f(x, u)`:
///
/// ```text
/// k₁ = f(x)                k₂ = f(x + h/2 k₁)
/// k₃ = f(x + h/2 k₂)       k₄ = f(x + h k₃)
/// x' = x + h/6 (k₁ + 2 k₂ + 2 k₃ + k₄)
/// ```
///
/// It has order 4 and four evaluations (Hairer, Nørsett and Wanner, Solving Ordinary Differential Equations I, 1993,
/// II.1). For equations of motion [`RungeKuttaNystrom4`](crate::RungeKuttaNystrom4) is the same method in fewer
/// operations.
///
/// ```
/// use lyapunov_core::{Integrator, State};
/// use lyapunov_plants::{Impedance, Oscillator, RungeKutta4};
/// let parts = Impedance { mass: 1.0, damping: 0.0, stiffness: 1.0 };
/// let (oscillator, start) = (Oscillator::new(parts)?, State { position: 1.0, velocity: 0.0 });
/// let gain = RungeKutta4.step(&oscillator, start, 0.0, 0.1_f64); // the change, not the new state
/// assert!((start.position + gain.position - 0.1_f64.cos()).abs() < 1e-7);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RungeKutta4;

impl<U: Signal, D: Dynamics<U>> Integrator<U, D> for RungeKutta4 {
    #[inline]
    fn step(&mut self, dynamics: &D, from: D::State, input: U, interval: U::Scalar) -> D::State {
        let half = interval * U::Scalar::of(0.5);
        let sixth = interval * U::Scalar::of(1.0 / 6.0);

        let first = dynamics.rate(from, input);
        let second = dynamics.rate(from + first.scale(half), input);
        let third = dynamics.rate(from + second.scale(half), input);
        let fourth = dynamics.rate(from + third.scale(interval), input);

        let inner = second + third;
        (first + inner + inner + fourth).scale(sixth)
    }
}
