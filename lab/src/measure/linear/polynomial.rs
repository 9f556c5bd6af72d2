//! Polynomials with about 31 digits.

use nalgebra::Complex;

use super::pair::Pair;
use lyapunov::accumulators::DoubleDouble;

/// Polynomial, by its coefficients from the constant one up.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Polynomial(Vec<DoubleDouble>);

impl Polynomial {
    pub(super) fn new(coefficients: Vec<DoubleDouble>) -> Self {
        Self(coefficients)
    }

    pub(super) fn coefficients(&self) -> &[DoubleDouble] {
        &self.0
    }

    /// The degree that its coefficients allow: the last one may be 0.
    pub(super) fn degree(&self) -> usize {
        self.0.len().saturating_sub(1)
    }

    pub(super) fn plus(&self, other: &Self) -> Self {
        let at = |it: &Self, power: usize| it.0.get(power).copied().unwrap_or_default();
        let length = self.0.len().max(other.0.len());
        Self((0..length).map(|power| at(self, power) + at(other, power)).collect())
    }

    pub(super) fn times(&self, other: &Self) -> Self {
        let mut product =
            vec![DoubleDouble::default(); (self.0.len() + other.0.len()).saturating_sub(1)];
        for (i, one) in self.0.iter().enumerate() {
            for (j, another) in other.0.iter().enumerate() {
                product[i + j] += *one * *another;
            }
        }
        Self(product)
    }

    pub(super) fn scaled(&self, by: DoubleDouble) -> Self {
        Self(self.0.iter().map(|it| *it * by).collect())
    }

    /// `p(−s)`.
    pub(super) fn mirrored(&self) -> Self {
        let sign =
            |power: usize| DoubleDouble::from(if power.is_multiple_of(2) { 1.0 } else { -1.0 });
        Self(self.0.iter().enumerate().map(|(power, it)| *it * sign(power)).collect())
    }

    /// The even and the odd part: `p(s) = e(−s²) + s o(−s²)`.
    pub(super) fn parts(&self) -> [Self; 2] {
        [0, 1].map(|first| Self(self.0.iter().skip(first).step_by(2).copied().collect()).mirrored())
    }

    /// `(1 − s)ⁿ p(2 s / (1 − s))`, for a degree of at most `n`.
    pub(super) fn turned(&self, n: usize) -> Self {
        let (up, down) = ([0.0, 2.0], [1.0, -1.0]);
        let of = |it: [f64; 2]| Self(it.map(DoubleDouble::from).to_vec());
        let power =
            |base: &Self, times: usize| (0..times).fold(of([1.0, 0.0]), |all, _| all.times(base));
        self.0.iter().enumerate().fold(Self::default(), |sum, (k, it)| {
            let term = power(&of(up), k).times(&power(&of(down), n - k));
            sum.plus(&term.scaled(*it))
        })
    }

    /// Value and derivative at `place`.
    pub(super) fn at(&self, place: Complex<f64>) -> [Complex<f64>; 2] {
        let zero = Complex::from(0.0);
        self.0.iter().rev().fold([zero, zero], |[value, slope], it| {
            [value * place + Complex::from(f64::from(*it)), slope * place + value]
        })
    }

    /// The value at `place`, to all digits.
    pub(super) fn long_at(&self, place: Pair) -> Pair {
        self.0.iter().rev().fold(Pair::default(), |value, it| {
            value.times(place).plus(Pair { re: *it, im: DoubleDouble::default() })
        })
    }

    /// The value at a real place, to all digits.
    pub(super) fn value(&self, place: DoubleDouble) -> DoubleDouble {
        self.0.iter().rev().fold(DoubleDouble::default(), |value, it| value * place + *it)
    }
}
