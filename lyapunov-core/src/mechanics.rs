//! Mechanics: the equation of motion of a mechanical system.

use crate::{Dynamics, Signal, State};

/// Equation of motion of a mechanical system under an effort at its port: `q̈ = a(q, q̇, f)`.
///
/// Every mechanical system is [`Dynamics`] of its [`State`], `d/dt (q, q̇) = (q̇, a(q, q̇, f))`, so that every
/// [`Integrator`](crate::Integrator) can move it. Methods that need the acceleration by itself ask for this trait.
/// A pendulum is
///
/// ```
/// use lyapunov_core::Mechanics;
/// /// Of length 1 m and mass 1 kg, to third order in the angle; the effort is a torque.
/// struct Pendulum;
/// impl Mechanics<f64> for Pendulum {
///     type Coordinates = f64;
///     fn acceleration(&self, angle: f64, _: f64, effort: f64) -> f64 {
///         -9.81 * (angle - angle * angle * angle / 6.0) - effort
///     }
/// }
/// ```
pub trait Mechanics<V: Signal> {
    /// The coordinates of the system: the port's own signal, or one with more axes for more masses.
    type Coordinates: Signal<Scalar = V::Scalar>;

    /// The acceleration of the coordinates, m/s², under `effort` at the port, N.
    ///
    /// As on a [`Plant`](crate::Plant), a positive effort accelerates the port backwards.
    fn acceleration(
        &self,
        position: Self::Coordinates,
        velocity: Self::Coordinates,
        effort: V,
    ) -> Self::Coordinates;
}

impl<V: Signal, D: Mechanics<V> + ?Sized> Mechanics<V> for &D {
    type Coordinates = D::Coordinates;

    #[inline]
    fn acceleration(
        &self,
        position: Self::Coordinates,
        velocity: Self::Coordinates,
        effort: V,
    ) -> Self::Coordinates {
        (**self).acceleration(position, velocity, effort)
    }
}

impl<V: Signal, D: Mechanics<V> + ?Sized> Dynamics<V> for D {
    type State = State<D::Coordinates>;

    #[inline]
    fn rate(&self, State { position, velocity }: Self::State, effort: V) -> Self::State {
        State { position: velocity, velocity: self.acceleration(position, velocity, effort) }
    }
}
