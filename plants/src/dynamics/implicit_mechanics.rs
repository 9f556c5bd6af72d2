//! Equations of motion that an implicit integrator can solve.

use lyapunov_core::{Mechanics, Signal};

/// An equation of motion that an implicit integrator can solve.
///
/// A nonlinear one uses a fixed count of Newton's iterations, so that every step takes the same time and every lane
/// does the same.
pub trait ImplicitMechanics<V: Signal>: Mechanics<V> {
    /// The acceleration `a` of the state that it leads to: `a = acceleration(q + α a, q̇ + β a, effort)`, `α` in s² and
    /// `β` in s, neither below 0: numbers of the integrator's step, no dampings.
    fn implicit_acceleration(
        &self,
        position: Self::Coordinates,
        velocity: Self::Coordinates,
        effort: V,
        alpha: V::Scalar,
        beta: V::Scalar,
    ) -> Self::Coordinates;
}
