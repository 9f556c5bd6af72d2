//! Forces that only push.

use lyapunov_core::Scalar;

/// `force` where it pushes at a `depth` above 0, else 0.
#[inline(always)]
pub(super) fn one_sided<T: Scalar>(depth: T, force: T) -> T {
    // In these forms a NaN does not pass for "no contact": it stays NaN, for a guard or stabilizer to reject. One number
    // jumps over the force where there is no contact; lanes cannot, and a maximum is one operation. The bits are the same.
    let (zero, is_free) = (T::zero(), depth.below(T::smallest_positive()));
    if T::LANES == 1 {
        T::choose(is_free | force.below(zero), zero, force)
    } else {
        T::choose(is_free, zero, zero.larger(force))
    }
}

/// The energy that a spring of `stiffness` N/m stores at a `depth`, J; 0 above the surface.
#[inline]
pub(super) fn depth_stored<T: Scalar>(stiffness: T, depth: T) -> T {
    let depth = depth.larger(T::zero());
    T::of(0.5) * stiffness * depth * depth
}
