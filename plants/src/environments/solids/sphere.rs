//! Ball.

use lyapunov_core::{ParameterError, Requirement, Scalar, Signal};
use nalgebra::SVector;

use super::axes::{check_axes, length_and_direction};
use crate::{NearestPoint, Solid};

/// A ball, on two axes a disc: `p = radius − |x − center|`, `n = (x − center) / |x − center|`.
///
/// At the very center all directions are equally near; it takes `+x`, the first axis.
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
        let center = check_axes(Requirement::Finite, "center", center)?;
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
