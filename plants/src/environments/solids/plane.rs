//! Half-space.

use lyapunov_core::{ParameterError, Requirement, Signal, largest_axis, length_and_direction};

use crate::{NearestPoint, Solid};

/// The half-space below a plane: `p = (point − x)·n`.
///
/// ```
/// use lyapunov_core::{OnePort, PortSample};
/// use lyapunov_plants::{Contact, Plane};
/// use nalgebra::Vector2;
/// let slope = Plane::new(Vector2::zeros(), Vector2::new(1.0, 1.0))?; // the normal need not have length 1
/// let mut floor = Contact::with(slope, 1000.0, 0.0)?;
/// let below = PortSample::starting(1e-3, Vector2::new(-0.01, 0.0), Vector2::zeros());
/// let effort: Vector2<f64> = floor.respond(&below);
/// assert!((effort - Vector2::new(-5.0, -5.0)).norm() < 1e-9); // 10 N/√2 along the normal
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane<V> {
    point: V,
    normal: V,
}

impl<V: Signal> Plane<V> {
    /// The solid below the plane through `point`, m, on the side away from `normal`, which may be of any length.
    ///
    /// # Errors
    /// A coordinate of `point` or of `normal` infinite or NaN; a `normal` of 0.
    pub fn new(point: V, normal: V) -> Result<Self, ParameterError> {
        Requirement::Finite.check_axes("point", point)?;
        Requirement::Finite.check_axes("normal", normal)?;
        Requirement::Positive.check("normal", largest_axis(normal))?;
        let (_, normal) = length_and_direction(normal, V::zero());
        Ok(Self { point, normal })
    }
}

impl<V: Signal> Solid<V> for Plane<V> {
    #[inline]
    fn nearest(&self, position: V) -> NearestPoint<V> {
        NearestPoint { depth: (self.point - position).inner(self.normal), normal: self.normal }
    }
}
