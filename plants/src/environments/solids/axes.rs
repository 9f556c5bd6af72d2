//! Checks and lengths over all axes of a signal.

use lyapunov_core::{ParameterError, Requirement, Scalar, Signal};

/// `value` if every axis of it meets the requirement.
pub(super) fn check_axes<V: Signal>(
    requirement: Requirement,
    parameter: &'static str,
    value: V,
) -> Result<V, ParameterError> {
    let mut refused = None;
    value.map(|axis| {
        refused = refused.or(requirement.check(parameter, axis).err());
        axis
    });
    refused.map_or(Ok(value), Err)
}

/// The largest magnitude on an axis.
#[inline]
pub(super) fn largest_axis<V: Signal>(value: V) -> V::Scalar {
    let mut largest = V::Scalar::of(0.0);
    value.map(|axis| {
        largest = axis.magnitude().larger(largest);
        axis
    });
    largest
}

/// The length of `value` and its direction; a value of 0 has none and gets `otherwise`.
#[inline]
pub(super) fn length_and_direction<V: Signal>(value: V, otherwise: V) -> (V::Scalar, V) {
    let largest = largest_axis(value);
    let none = largest.below(V::Scalar::smallest_positive());
    // Scaling first keeps every square in range; a NaN, which is never the largest, stays in the sum.
    let unit = V::Scalar::choose(none, V::Scalar::of(1.0), largest);
    let scaled = value.map(|axis| axis / unit);
    let length = scaled.inner(scaled).sqrt();
    (largest * length, V::choose(none, otherwise, scaled.map(|axis| axis / length)))
}
