//! What follows an equation of motion through time.

use crate::{Dynamics, Signal, State};

/// A one-step method: it follows an equation of motion over an interval under a held effort.
///
/// It answers with what the state *gains*, not with the new state: a gain is a small number with digits of its own,
/// and whoever sums chooses how. Over no time it gains exactly nothing. What an integrator remembers from step to
/// step (a matrix, a step size) is in its value.
///
/// ```
/// use lyapunov_core::{Dynamics, Integrator, Signal, State};
/// /// Euler's method, of order 1.
/// struct Euler;
/// impl<V: Signal, D: Dynamics<V>> Integrator<V, D> for Euler {
///     fn step(
///         &mut self,
///         dynamics: &D,
///         from: State<D::Coordinates>,
///         effort: V,
///         interval: V::Scalar,
///     ) -> State<D::Coordinates> {
///         let acceleration = dynamics.acceleration(from.position, from.velocity, effort);
///         State {
///             position: from.velocity.scale(interval),
///             velocity: acceleration.scale(interval),
///         }
///     }
/// }
/// ```
pub trait Integrator<V: Signal, D: Dynamics<V>> {
    /// What `from` gains over `interval` s, while `effort` is held.
    fn step(
        &mut self,
        dynamics: &D,
        from: State<D::Coordinates>,
        effort: V,
        interval: V::Scalar,
    ) -> State<D::Coordinates>;
}

impl<V: Signal, D: Dynamics<V>, I: Integrator<V, D> + ?Sized> Integrator<V, D> for &mut I {
    #[inline]
    fn step(
        &mut self,
        dynamics: &D,
        from: State<D::Coordinates>,
        effort: V,
        interval: V::Scalar,
    ) -> State<D::Coordinates> {
        (**self).step(dynamics, from, effort, interval)
    }
}
