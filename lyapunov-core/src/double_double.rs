//! Double-double: a scalar of about thirty digits.

use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Zero};

use crate::exact_sum::exact_sum;
use crate::one_axis;
use crate::{Scalar, Signal};

/// Unevaluated sum of two `f64`, the second below half a unit in the last place of the first: about 31 digits over
/// the range of `f64`.
///
/// It serves references, and sums wider than an `f64` port's; an operation costs some tens of `f64` operations. The
/// relative error of a result is at most [`epsilon`](Scalar::epsilon), `2⁻¹⁰²`, as long as the sizes of its parts
/// stay above `10⁻²⁷⁰` and below `10³⁰⁰`; beyond, digits are lost down to those of `f64`. Infinities, NaN and
/// overflow are as in `f64`.
///
/// Sums use the error-free sum of two numbers (Knuth, The Art of Computer Programming, volume 2, section 4.2.2),
/// products the error-free product of two numbers (Dekker, A floating-point technique for extending the available
/// precision, Numerische Mathematik 18, 1971); no fused multiply-add, so the bits are the same on every machine.
///
/// ```
/// use lyapunov_core::{DoubleDouble, Scalar};
/// let third = DoubleDouble::of(1.0) / DoubleDouble::of(3.0);
/// let lacking = third + third + third - DoubleDouble::of(1.0);
/// assert!(lacking.magnitude().below(DoubleDouble::epsilon()));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(from = "(f64, f64)", into = "(f64, f64)"))]
pub struct DoubleDouble {
    high: f64,
    low: f64,
}

impl DoubleDouble {
    /// `a + b` without rounding.
    #[inline]
    pub fn sum_of(a: f64, b: f64) -> Self {
        let (high, low) = exact_sum(a, b);
        Self { high, low: sound(low) }
    }

    /// `a b` without rounding.
    #[inline]
    pub fn product_of(a: f64, b: f64) -> Self {
        let high = a * b;
        let ([a, rest_of_a], [b, rest_of_b]) = (halves(a), halves(b));
        let cross = ((a * b - high) + a * rest_of_b) + rest_of_a * b;
        Self { high, low: sound(cross + rest_of_a * rest_of_b) }
    }

    /// The nearest `f64`.
    #[inline]
    pub fn high(self) -> f64 {
        self.high
    }

    /// The remainder beyond the nearest `f64`.
    #[inline]
    pub fn low(self) -> f64 {
        self.low
    }

    /// `high + low`, if `low` is the smaller or both are 0.
    #[inline]
    fn normalized(high: f64, low: f64) -> Self {
        if low == 0.0 {
            return Self { high, low: 0.0 };
        }
        let sum = high + low;
        Self { high: sum, low: sound(low - (sum - high)) }
    }
}

/// The rounding error of an operation, or 0 where it is not finite.
#[inline]
fn sound(error: f64) -> f64 {
    if error.is_finite() { error } else { 0.0 }
}

/// Two numbers of 26 digits each that add up to `value` (Veltkamp's splitting).
#[inline]
fn halves(value: f64) -> [f64; 2] {
    let spread = 134_217_729.0 * value; // 2^27 + 1
    let first = spread - (spread - value);
    [first, value - first]
}

/// The sum of two numbers, which need not be apart in size.
impl From<(f64, f64)> for DoubleDouble {
    #[inline]
    fn from((high, low): (f64, f64)) -> Self {
        // A sum would turn −0 into 0.
        if low == 0.0 { Self { high, low } } else { Self::sum_of(high, low) }
    }
}

impl From<DoubleDouble> for (f64, f64) {
    #[inline]
    fn from(value: DoubleDouble) -> Self {
        (value.high, value.low)
    }
}

impl From<f64> for DoubleDouble {
    #[inline]
    fn from(value: f64) -> Self {
        Self { high: value, low: 0.0 }
    }
}

impl From<DoubleDouble> for f64 {
    #[inline]
    fn from(value: DoubleDouble) -> Self {
        value.high
    }
}

impl Zero for DoubleDouble {
    fn zero() -> Self {
        Self { high: 0.0, low: 0.0 }
    }

    fn is_zero(&self) -> bool {
        self.high == 0.0
    }
}

impl One for DoubleDouble {
    fn one() -> Self {
        Self { high: 1.0, low: 0.0 }
    }
}

impl Add for DoubleDouble {
    type Output = Self;

    #[inline(never)]
    fn add(self, other: Self) -> Self {
        let (high, low) = (Self::sum_of(self.high, other.high), Self::sum_of(self.low, other.low));
        let once = Self::normalized(high.high, high.low + low.high);
        Self::normalized(once.high, once.low + low.low)
    }
}

impl Neg for DoubleDouble {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Sub for DoubleDouble {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;

    #[inline(never)]
    fn mul(self, other: Self) -> Self {
        let product = Self::product_of(self.high, other.high);
        let cross = sound(self.high * other.low + self.low * other.high);
        Self::normalized(product.high, product.low + cross)
    }
}

impl Div for DoubleDouble {
    type Output = Self;

    #[inline(never)]
    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        if !first.is_finite() || !other.high.is_finite() {
            return Self { high: first, low: 0.0 };
        }
        let rest = self - other * Self { high: first, low: 0.0 };
        let second = rest.high / other.high;
        let rest = rest - other * Self { high: second, low: 0.0 };
        let quotient =
            Self::normalized(first, second) + Self { high: rest.high / other.high, low: 0.0 };
        // Beside the largest number the remainders are out of range.
        if quotient.high.is_finite() { quotient } else { Self { high: first, low: 0.0 } }
    }
}

impl AddAssign for DoubleDouble {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for DoubleDouble {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl MulAssign for DoubleDouble {
    #[inline]
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

impl Signal for DoubleDouble {
    type Scalar = Self;

    one_axis!(
        #[inline]
        Self
    );

    #[inline]
    fn choose(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }

    #[inline]
    fn finite(self) -> bool {
        self.high.is_finite()
    }
}

impl Scalar for DoubleDouble {
    type Mask = bool;

    type Real = Self;

    const LANES: usize = 1;

    #[inline]
    fn from_lanes(mut value: impl FnMut(usize) -> f64) -> Self {
        Self { high: value(0), low: 0.0 }
    }

    #[inline]
    fn lane(self, index: usize) -> f64 {
        if index == 0 { self.high } else { f64::NAN }
    }

    #[inline]
    fn from_reals(mut value: impl FnMut(usize) -> Self) -> Self {
        value(0)
    }

    #[inline]
    fn real(self, index: usize) -> Self {
        if index == 0 { self } else { Self { high: f64::NAN, low: 0.0 } }
    }

    #[inline]
    fn smallest_normal() -> Self {
        Self { high: f64::MIN_POSITIVE, low: 0.0 }
    }

    #[inline]
    fn smallest_positive() -> Self {
        Self { high: f64::from_bits(1), low: 0.0 }
    }

    #[inline]
    fn largest() -> Self {
        Self { high: f64::MAX, low: f64::MAX * (f64::EPSILON / 4.0) }
    }

    /// `2⁻¹⁰²`, the largest relative error of an operation; the next number above one may be nearer.
    #[inline]
    fn epsilon() -> Self {
        Self { high: 4.0 * f64::EPSILON * f64::EPSILON, low: 0.0 }
    }

    /// The square root, to [`epsilon`](Self::epsilon).
    #[inline]
    fn sqrt(self) -> Self {
        let near = Scalar::sqrt(self.high);
        if !near.is_finite() || near == 0.0 {
            return Self { high: near, low: 0.0 };
        }
        // One Newton step doubles the digits.
        let rest = self - Self::product_of(near, near);
        Self::normalized(near, rest.high / (2.0 * near))
    }

    #[inline]
    fn below(self, other: Self) -> bool {
        self.high < other.high || (self.high == other.high && self.low < other.low)
    }

    #[inline]
    fn rounded(self) -> Self {
        let (half, one) = (Self::of(0.5), Self::one());
        let near = Self::sum_of(self.high.rounded(), self.low.rounded());
        let (over, up) = (self - near, self.above(Self::zero()));
        if over.above(half) || (over == half && up) {
            near + one
        } else if over.below(-half) || (over == -half && !up) {
            near - one
        } else {
            near
        }
    }
}
