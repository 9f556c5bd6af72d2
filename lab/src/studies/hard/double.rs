//! Sums of products with about 32 digits, to hold the ledger's sums against.

/// An unevaluated sum of two `f64`: the number and what it lacks (Dekker, Numerische Mathematik 18, 1971).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Double {
    high: f64,
    low: f64,
}

impl Double {
    /// The product of two `f64`, exact where nothing underflows.
    pub(super) fn product(a: f64, b: f64) -> Self {
        let high = a * b;
        Self { high, low: a.mul_add(b, -high) }
    }

    /// This times `factor`.
    pub(super) fn times(self, factor: f64) -> Self {
        let product = Self::product(self.high, factor);
        Self::normal(product.high, product.low + self.low * factor)
    }

    /// This plus `other`.
    pub(super) fn plus(self, other: Self) -> Self {
        let high = self.high + other.high;
        let share = high - self.high;
        let error = (self.high - (high - share)) + (other.high - share);
        Self::normal(high, error + (self.low + other.low))
    }

    /// The nearest `f64`.
    pub(super) fn value(self) -> f64 {
        self.high
    }

    fn normal(high: f64, low: f64) -> Self {
        let sum = high + low;
        Self { high: sum, low: low - (sum - high) }
    }
}

impl From<f64> for Double {
    fn from(high: f64) -> Self {
        Self { high, low: 0.0 }
    }
}
