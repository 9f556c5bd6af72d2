//! `Solid` trait: a solid, known by the nearest point of its surface.

use lyapunov_core::Signal;

/// Nearest point on the surface of a solid, seen from a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearestPoint<V: Signal> {
    /// Depth of the point below its nearest point on the surface, m; above 0 inside the solid only.
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
/// /// An endless cylinder about the z axis.
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
    /// The nearest point of the surface, for a point inside. For a point outside, only a depth not above 0 is required;
    /// where `position` is NaN, the depth is NaN.
    fn nearest(&self, position: V) -> NearestPoint<V>;
}
