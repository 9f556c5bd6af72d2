//! Sums and products with about 32 digits, to check `f64` against.

use approx::assert_abs_diff_eq;
use std::ops::{Add, Mul, Neg, Sub};

/// An unevaluated sum of two `f64`: the number and its error (Dekker, Numerische Mathematik 18, 1971).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Double {
    high: f64,
    low: f64,
}

impl Double {
    pub(crate) fn of(value: f64) -> Self {
        Self { high: value, low: 0.0 }
    }

    /// The product of two `f64`, exact where nothing underflows.
    pub(crate) fn product(a: f64, b: f64) -> Self {
        let high = a * b;
        Self { high, low: a.mul_add(b, -high) }
    }

    pub(crate) fn value(self) -> f64 {
        self.high
    }

    pub(crate) fn over(self, divisor: Self) -> Self {
        let first = self.high / divisor.high;
        let rest = self - divisor * Self::of(first);
        Self::renormalized(first, rest.high / divisor.high)
    }

    fn renormalized(high: f64, low: f64) -> Self {
        let sum = high + low;
        Self { high: sum, low: low - (sum - high) }
    }
}

impl Add for Double {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let high = self.high + other.high;
        let share = high - self.high;
        let error = (self.high - (high - share)) + (other.high - share);
        Self::renormalized(high, error + (self.low + other.low))
    }
}

impl Neg for Double {
    type Output = Self;

    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Sub for Double {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Double {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let product = Self::product(self.high, other.high);
        let cross = self.high * other.low + self.low * other.high;
        Self::renormalized(product.high, product.low + cross)
    }
}

/// `(1 + 2⁻⁶⁰)² − 1 = 2⁻⁵⁹ + 2⁻¹²⁰`, which an `f64` would lose.
#[test]
fn keeps_what_f64_drops() {
    let small = 2f64.powi(-60);
    let sum = Double::of(1.0) + Double::of(small);
    let square = sum * sum - Double::of(1.0);
    assert_abs_diff_eq!(square.value(), 2.0 * small, epsilon = 4.0 * 2f64.powi(-104));
    let third = Double::of(1.0).over(Double::of(3.0));
    let whole = third + third + third - Double::of(1.0);
    assert!(whole.value().abs() <= 2f64.powi(-102));
}
