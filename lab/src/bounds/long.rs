//! Numbers with about 32 digits.

use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Zero};

/// An unevaluated sum of two `f64`, the second less than half a unit in the last place of the first.
///
/// Sum, product and quotient are off by a few parts in 10³² (Dekker, Numerische Mathematik 18, 1971; Joldes, Muller and
/// Popescu, ACM Transactions on Mathematical Software 44, 2017, algorithms 6, 12 and 17). With products to twice the digits
/// from `libm`, they are the same on every machine.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Long {
    high: f64,
    low: f64,
}

impl Long {
    /// `high + low` for a `low` that is the smaller one.
    fn of(high: f64, low: f64) -> Self {
        let sum = high + low;
        Self { high: sum, low: low - (sum - high) }
    }

    /// The exact sum of two `f64`.
    fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let share = high - a;
        Self { high, low: (a - (high - share)) + (b - share) }
    }

    /// The exact product of two `f64`, but for what underflows.
    fn product(a: f64, b: f64) -> Self {
        let high = a * b;
        Self { high, low: libm::fma(a, b, -high) }
    }
}

impl From<f64> for Long {
    fn from(value: f64) -> Self {
        Self { high: value, low: 0.0 }
    }
}

impl From<Long> for f64 {
    fn from(value: Long) -> Self {
        value.high
    }
}

impl Add for Long {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (high, low) = (Self::sum(self.high, other.high), Self::sum(self.low, other.low));
        let first = Self::of(high.high, high.low + low.high);
        Self::of(first.high, low.low + first.low)
    }
}

impl Neg for Long {
    type Output = Self;

    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Sub for Long {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Long {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let product = Self::product(self.high, other.high);
        let cross = libm::fma(self.high, other.low, self.low * other.high);
        Self::of(product.high, product.low + cross)
    }
}

impl Div for Long {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        let rest = self - other * Self::from(first);
        let second = rest.high / other.high;
        let rest = rest - other * Self::from(second);
        Self::of(first, second) + Self::from(rest.high / other.high)
    }
}

impl AddAssign for Long {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Long {
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl MulAssign for Long {
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

impl Zero for Long {
    fn zero() -> Self {
        Self::default()
    }

    fn is_zero(&self) -> bool {
        self.high == 0.0
    }
}

impl One for Long {
    fn one() -> Self {
        Self::from(1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn long(value: f64) -> Long {
        Long::from(value)
    }

    #[test]
    fn what_f64_drops_is_kept() {
        let small = long(2f64.powi(-60));
        let square = (long(1.0) + small) * (long(1.0) + small) - long(1.0);
        assert_eq!(square - small - small - small * small, long(0.0));
        for divisor in [3.0, 7.0, 0.1, 1e-9] {
            let quotient = long(1.0) / long(divisor);
            let back = f64::from(quotient * long(divisor) - long(1.0));
            assert!(back.abs() < 1e-31, "{divisor} {back:e}");
        }
    }
}
