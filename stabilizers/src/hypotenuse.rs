//! Hypotenuse without squares that are out of range.

use lyapunov_core::Scalar;

/// `√(a² + b²)`.
#[inline(always)]
pub(crate) fn hypotenuse<T: Scalar>(a: T, b: T) -> T {
    let (a, b) = (a.magnitude(), b.magnitude());
    let (large, small) = (a.larger(b), a.smaller(b));
    let ratio = small / large.larger(T::smallest_normal());
    large * (T::of(1.0) + ratio * ratio).sqrt()
}
