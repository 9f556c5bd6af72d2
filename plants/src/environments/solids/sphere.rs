//! Ball.

use lyapunov_core::{ParameterError, Requirement, Scalar, Signal, length_and_direction};
use nalgebra::SVector;

use crate::{NearestPoint, Solid};

/// A ball, on two axes a disc: `p = radius − |x − center|`, `n = (x − center) / |x − center|`.
///
/// At the very center all directions are equally near; it takes `+x`, the first axis.
///
/// ```
/// use lyapunov_core::{OnePort, PortSample};
/// use lyapunov_plants::{Contact, Sphere};
/// use nalgebra::Vector3;
/// let mut ball = Contact::with(Sphere::new(Vector3::zeros(), 0.05)?, 2000.0, 0.0)?;
/// let inside = PortSample::starting(1e-3, Vector3::new(0.0, 0.0, 0.049), Vector3::zeros());
/// let effort: Vector3<f64> = ball.respond(&inside); // acts against the device, which is pushed out
/// assert!((effort - Vector3::new(0.0, 0.0, -2.0)).norm() < 1e-9);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere<V: Signal> {
    center: V,
    radius: V::Scalar,
}

impl<V: Signal> Sphere<V> {
    /// A ball of `radius` m about `center`.
    ///
    /// # Errors
    /// A coordinate of `center` infinite or NaN; `radius` not above 0 and finite.
    pub fn new(center: V, radius: V::Scalar) -> Result<Self, ParameterError> {
        let center = Requirement::Finite.check_axes("center", center)?;
        Ok(Self { center, radius: Requirement::Positive.check("radius", radius)? })
    }
}

impl<T: Scalar, const N: usize> Solid<SVector<T, N>> for Sphere<SVector<T, N>> {
    #[inline]
    fn nearest(&self, position: SVector<T, N>) -> NearestPoint<SVector<T, N>> {
        let first = SVector::from_fn(|axis, _| T::of(if axis == 0 { 1.0 } else { 0.0 }));
        let (distance, normal) = length_and_direction(position - self.center, first);
        NearestPoint { depth: self.radius - distance, normal }
    }
}
