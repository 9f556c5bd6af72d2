//! Semi-implicit Euler method: order 1, symplectic.

use lyapunov_core::{Integrator, Mechanics, Signal, State};

/// The semi-implicit, or symplectic, Euler method: `v' = v + h a(x, v, f)`, then `x' = x + h v'`.
///
/// It has order 1 and one evaluation. Without damping it keeps, exactly, an energy close to the true one: for
/// `ẍ = −ω² x` it is `v² + ω² x² − h ω² x v`, so the true energy varies by a factor of at most
/// `(1 + h ω / 2) / (1 − h ω / 2)` and never grows while `h ω < 2` (Hairer, Lubich and Wanner, Geometric Numerical
/// Integration, 2006, I.1 and VI.3). Damping is explicit: the method is stable while `h (b / m + h k / (2 m)) < 2`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SemiImplicitEuler;

impl<V: Signal, D: Mechanics<V>> Integrator<V, D> for SemiImplicitEuler {
    #[inline]
    fn step(
        &mut self,
        dynamics: &D,
        from: State<D::Coordinates>,
        effort: V,
        interval: V::Scalar,
    ) -> State<D::Coordinates> {
        let acceleration = dynamics.acceleration(from.position, from.velocity, effort);
        let velocity = acceleration.scale(interval);
        State { position: (from.velocity + velocity).scale(interval), velocity }
    }
}
