//! Complex numbers with about 31 digits.

use lyapunov::accumulators::DoubleDouble;
use nalgebra::Complex;
use num_traits::{One, Zero};

/// Complex number of two [`DoubleDouble`]s.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Pair {
    pub(super) re: DoubleDouble,
    pub(super) im: DoubleDouble,
}

impl Pair {
    pub(super) fn one() -> Self {
        Self { re: DoubleDouble::one(), im: DoubleDouble::zero() }
    }

    pub(super) fn plus(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }

    pub(super) fn times(self, other: Self) -> Self {
        Self {
            re: self.re * other.re - self.im * other.im,
            im: self.re * other.im + self.im * other.re,
        }
    }
}

impl From<Complex<f64>> for Pair {
    fn from(value: Complex<f64>) -> Self {
        Self { re: value.re.into(), im: value.im.into() }
    }
}

impl From<Pair> for Complex<f64> {
    fn from(value: Pair) -> Self {
        Self::new(value.re.into(), value.im.into())
    }
}
