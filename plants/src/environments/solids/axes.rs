//! Lengths over all axes of a signal.

use lyapunov_core::{Scalar, Signal};

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
