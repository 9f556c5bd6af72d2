//! Sum of two numbers without an error.

use crate::{Scalar, Signal};

/// The sum of two numbers and the error of its rounding: together they are `a + b` to the bit, where nothing overflows (Knuth,
/// The Art of Computer Programming, volume 2, section 4.2.2, theorem B).
///
/// For the crates of this library: each keeps sums whose errors it carries on.
#[doc(hidden)]
#[inline(always)]
pub fn exact_sum<T: Scalar>(a: T, b: T) -> (T, T) {
    let sum = a + b;
    let share = sum - a;
    (sum, (a - (sum - share)) + (b - share))
}

/// The same of two signals, axis by axis.
#[doc(hidden)]
#[inline(always)]
pub fn exact_sums<V: Signal>(a: V, b: V) -> (V, V) {
    (a.zip(b, |a, b| exact_sum(a, b).0), a.zip(b, |a, b| exact_sum(a, b).1))
}
