//! What pushes only.

use lyapunov_core::Scalar;

/// `force` where it pushes at a `depth` above 0, else 0.
#[inline(always)]
pub(super) fn one_sided<T: Scalar>(depth: T, force: T) -> T {
    // Asked this way round, a NaN does not pass for "no contact": it stays one, to be turned away.
    let free = depth.below(T::least()) | force.below(T::zero());
    T::choose(free, T::zero(), force)
}
