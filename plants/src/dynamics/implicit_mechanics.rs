//! Equations of motion that can be solved where they lead.

use lyapunov_core::{Mechanics, Signal};

/// An equation of motion that an implicit integrator can solve.
///
/// One that is not linear solves by a fixed count of Newton's iterations, so that a step takes the same time every
/// time and each lane does the same.
pub trait ImplicitMechanics<V: Signal>: Mechanics<V> {
    /// The acceleration `a` that is the one where it leads: `a = acceleration(q + α a, q̇ + β a, effort)`, `α` in s²
    /// and `β` in s, neither below 0.
    fn implicit_acceleration(
        &self,
        position: Self::Coordinates,
        velocity: Self::Coordinates,
        effort: V,
        alpha: V::Scalar,
        beta: V::Scalar,
    ) -> Self::Coordinates;
}
