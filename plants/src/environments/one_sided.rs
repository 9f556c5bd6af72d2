//! What pushes only.

use lyapunov_core::Scalar;

/// `force` where it pushes at a `depth` above 0, else 0.
#[inline(always)]
pub(super) fn one_sided<T: Scalar>(depth: T, force: T) -> T {
    // Asked this way round, a NaN does not pass for "no contact": it stays one, to be turned away.
    let free = depth.below(T::smallest_positive()) | force.below(T::zero());
    T::choose(free, T::zero(), force)
}

/// What a spring of `stiffness` N/m stores at a `depth`, J; nothing above the surface.
#[inline]
pub(super) fn depth_stored<T: Scalar>(stiffness: T, depth: T) -> T {
    let depth = depth.larger(T::zero());
    T::of(0.5) * stiffness * depth * depth
}
