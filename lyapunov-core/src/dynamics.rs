//! The equation of motion of what an integrator moves.

use core::ops::Add;

use crate::Signal;

/// Where a mechanical system is and how it moves; or what both gain over an interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State<Q> {
    /// The coordinates, m.
    pub position: Q,
    /// Their rates, m/s.
    pub velocity: Q,
}

impl<Q: Add<Output = Q>> Add for State<Q> {
    type Output = Self;

    #[inline]
    fn add(self, gain: Self) -> Self {
        Self { position: self.position + gain.position, velocity: self.velocity + gain.velocity }
    }
}

/// The equation of motion of a mechanical system under an effort at its port: `q̈ = a(q, q̇, f)`.
///
/// It does not depend on time: what follows time acts through the effort, which is held. A pendulum is
///
/// ```
/// use lyapunov_core::Dynamics;
/// /// Of length 1 m and mass 1 kg, to third order in the angle; the effort is a torque.
/// struct Pendulum;
/// impl Dynamics<f64> for Pendulum {
///     type Coordinates = f64;
///     fn acceleration(&self, angle: f64, _: f64, effort: f64) -> f64 {
///         -9.81 * (angle - angle * angle * angle / 6.0) - effort
///     }
/// }
/// ```
pub trait Dynamics<V: Signal> {
    /// What says where the system is: the port's own signal, or one with more axes for more masses.
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

impl<V: Signal, D: Dynamics<V> + ?Sized> Dynamics<V> for &D {
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
