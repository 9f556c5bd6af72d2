//! Numbers with their 95 % intervals.

use serde::Serialize;

use crate::text::given;

/// No interval is narrower than this share of its number: rounding.
const ROUNDING: f64 = 1e-9;

/// A number with its 95 % interval.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Estimate {
    /// The number.
    pub value: f64,
    /// The lower end of its interval.
    pub low: f64,
    /// The upper end of its interval.
    pub high: f64,
}

impl Estimate {
    /// `value`, with an interval that reaches as far to both sides of `middle`; `size` is the magnitude that rounding goes by.
    pub(super) fn about(value: f64, middle: f64, reach: f64, size: f64) -> Self {
        let reach = reach.max(ROUNDING * size.abs());
        Self { value, low: (middle - reach).min(value), high: (middle + reach).max(value) }
    }

    /// The same number with an interval that spans the `other`'s too.
    pub(super) fn or(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high), ..self }
    }

    /// A position from `origin` on, with its interval, as one from 0 on.
    pub(super) fn from(self, origin: f64) -> Self {
        let [value, low, high] = [self.value, self.low, self.high].map(|it| origin + it);
        Self { value, low, high }
    }

    /// Number and interval, with as many digits as tell its ends apart.
    pub(super) fn words(&self) -> [String; 3] {
        let size = self.low.abs().max(self.high.abs());
        let digits = (size / (self.high - self.low)).log10().ceil().clamp(2.0, 7.0) as usize + 1;
        let rounded = |it: f64| format!("{it:.digits$e}").parse().unwrap_or(it);
        [self.value, self.low, self.high].map(|it| given(rounded(it)).to_string())
    }

    /// One divided by the number.
    pub(super) fn inverse(self) -> Option<Self> {
        let Self { value, low, high } = self;
        (low > 0.0).then(|| Self { value: value.recip(), low: high.recip(), high: low.recip() })
    }

    /// Whether the data tell it from 0.
    pub fn is_told(&self) -> bool {
        self.low > 0.0 || self.high < 0.0
    }
}
