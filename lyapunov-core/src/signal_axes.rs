//! Axes of a signal: their number, one of them, the largest, and the length over all.

use crate::{Scalar, Signal};

/// The number of axes.
pub(crate) fn axes<V: Signal>() -> usize {
    let mut count = 0;
    V::zero().map(|axis| {
        count += 1;
        axis
    });
    count
}

/// The axis of that `index`; NaN past the last one.
pub(crate) fn axis_of<V: Signal>(signal: V, index: usize) -> V::Scalar {
    let (mut at, mut found) = (0, V::Scalar::of(f64::NAN));
    signal.map(|axis| {
        found = if at == index { axis } else { found };
        at += 1;
        axis
    });
    found
}

/// The largest magnitude on an axis; a NaN is never the largest.
///
/// For the crates of this library.
#[doc(hidden)]
#[inline]
pub fn largest_axis<V: Signal>(signal: V) -> V::Scalar {
    let mut largest = V::Scalar::of(0.0);
    signal.map(|axis| {
        largest = axis.magnitude().larger(largest);
        axis
    });
    largest
}

/// The length of `signal` and its direction; a signal of 0 has none and gets `otherwise`.
#[doc(hidden)]
#[inline]
pub fn length_and_direction<V: Signal>(signal: V, otherwise: V) -> (V::Scalar, V) {
    let largest = largest_axis(signal);
    let none = largest.below(V::Scalar::smallest_positive());
    // Scaling first keeps every square in range; a NaN, which is never the largest, stays in the sum.
    let unit = V::Scalar::choose(none, V::Scalar::of(1.0), largest);
    let scaled = signal.map(|axis| axis / unit);
    let length = scaled.inner(scaled).sqrt();
    (largest * length, V::choose(none, otherwise, scaled.map(|axis| axis / length)))
}
