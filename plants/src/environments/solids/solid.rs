//! What a point can be inside of.

use lyapunov_core::Signal;

/// Where the surface of a solid is, seen from a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearestPoint<V: Signal> {
    /// How deep the point is below its nearest point on the surface, m; above 0 inside the solid only.
    pub depth: V::Scalar,
    /// The outward normal there, of length 1.
    pub normal: V,
}

/// A solid, known by the nearest point of its surface.
///
/// ```
/// use lyapunov_core::{ParameterError, Signal};
/// use lyapunov_plants::{Contact, NearestPoint, Solid};
/// use nalgebra::Vector3;
/// /// Round about the z axis, without end.
/// struct Cylinder { radius: f64 }
/// impl Solid<Vector3<f64>> for Cylinder {
///     fn nearest(&self, position: Vector3<f64>) -> NearestPoint<Vector3<f64>> {
///         let arm = Vector3::new(position.x, position.y, 0.0);
///         let normal = if arm.norm() > 0.0 { arm / arm.norm() } else { Vector3::x() };
///         NearestPoint { depth: self.radius - arm.norm(), normal }
///     }
/// }
/// let rod = Contact::with(Cylinder { radius: 0.01 }, 1000.0, 0.0)?;
/// # Ok::<(), ParameterError>(())
/// ```
pub trait Solid<V: Signal> {
    /// The nearest point of the surface, for a point inside. Of one outside only that the depth is not above 0 is
    /// asked; where `position` is NaN, the depth is.
    fn nearest(&self, position: V) -> NearestPoint<V>;
}
