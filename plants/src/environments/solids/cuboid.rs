//! Box with its edges along the axes.

use lyapunov_core::{ParameterError, Requirement, Scalar, Signal};
use nalgebra::SVector;

use crate::{NearestPoint, Solid};

/// A box with its edges along the axes, on two axes a rectangle: `p = minᵢ (halfᵢ − |xᵢ − centerᵢ|)`, and `n` along
/// that axis towards the point's side.
///
/// Of axes with the same depth the first counts; exactly in the middle of an axis, the side `+`.
///
/// ```
/// use lyapunov_core::{OnePort, PortSample};
/// use lyapunov_plants::{Contact, Cuboid};
/// use nalgebra::Vector2;
/// let table = Cuboid::new(Vector2::zeros(), Vector2::new(0.5, 0.1))?;
/// let mut table = Contact::with(table, 1000.0, 0.0)?;
/// let under = PortSample::starting(1e-3, Vector2::new(0.2, 0.09), Vector2::zeros());
/// let effort: Vector2<f64> = table.respond(&under); // out through the nearest face
/// assert!((effort - Vector2::new(0.0, -10.0)).norm() < 1e-9);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cuboid<V> {
    center: V,
    half: V,
}

impl<V: Signal> Cuboid<V> {
    /// A box about `center` that extends by `half`, m, to each side.
    ///
    /// # Errors
    /// A coordinate of `center` infinite or NaN; one of `half` not above 0 and finite.
    pub fn new(center: V, half: V) -> Result<Self, ParameterError> {
        let center = Requirement::Finite.check_axes("center", center)?;
        Ok(Self { center, half: Requirement::Positive.check_axes("half", half)? })
    }
}

impl<T: Scalar, const N: usize> Solid<SVector<T, N>> for Cuboid<SVector<T, N>> {
    #[inline]
    fn nearest(&self, position: SVector<T, N>) -> NearestPoint<SVector<T, N>> {
        let from = position - self.center;
        let (zero, one) = (T::of(0.0), T::of(1.0));
        let mut least = T::largest();
        let mut normal = SVector::<T, N>::zeros();
        for axis in 0..N {
            let depth = self.half[axis] - from[axis].magnitude();
            let nearer = depth.below(least);
            least = T::choose(nearer, depth, least);
            normal = Signal::choose(nearer, SVector::zeros(), normal);
            let side = T::choose(from[axis].below(zero), -one, one);
            normal[axis] = T::choose(nearer, side, normal[axis]);
        }
        // A NaN counts as nearest: the other axes alone do not determine the depth.
        let known = from.finite();
        NearestPoint { depth: T::choose(known, least, T::of(f64::NAN)), normal }
    }
}
