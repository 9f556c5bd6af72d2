//! Sines and cosines of scalars.

use lyapunov_core::Scalar;

/// The sine, lane by lane in `f64`, rounded once.
#[inline]
pub(super) fn sin<T: Scalar>(angle: T) -> T {
    T::from_lanes(|lane| libm::sin(angle.lane(lane)))
}

/// The cosine, lane by lane in `f64`, rounded once.
#[inline]
pub(super) fn cos<T: Scalar>(angle: T) -> T {
    T::from_lanes(|lane| libm::cos(angle.lane(lane)))
}

/// `1 − cos`, without cancellation: `2 sin²(angle / 2)`.
#[inline]
pub(super) fn versine<T: Scalar>(angle: T) -> T {
    let half = sin(angle * T::of(0.5));
    T::of(2.0) * half * half
}
