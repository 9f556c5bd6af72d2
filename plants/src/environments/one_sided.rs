//! Forces that only push.

use lyapunov_core::Scalar;

/// `force` where it pushes at a `depth` above 0, else 0.
#[inline(always)]
pub(super) fn one_sided<T: Scalar>(depth: T, force: T) -> T {
    // In this form a NaN does not pass for "no contact": it stays NaN, for a guard or stabilizer to reject.
    let free = depth.below(T::smallest_positive()) | force.below(T::zero());
    T::choose(free, T::zero(), force)
}

/// The energy that a spring of `stiffness` N/m stores at a `depth`, J; 0 above the surface.
#[inline]
pub(super) fn depth_stored<T: Scalar>(stiffness: T, depth: T) -> T {
    let depth = depth.larger(T::zero());
    T::of(0.5) * stiffness * depth * depth
}
