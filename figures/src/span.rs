//! Range of an axis.

/// Range of an axis, in the axis's unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Span {
    pub(super) low: f64,
    pub(super) high: f64,
}

impl Span {
    /// Range of axes without any data.
    pub(super) const UNIT: Self = Self { low: 0.0, high: 1.0 };

    /// Range of the finite ones among the values.
    pub(super) fn of(values: impl IntoIterator<Item = f64>) -> Option<Self> {
        values.into_iter().filter(|value| value.is_finite()).fold(None, |span, value| match span {
            None => Some(Self { low: value, high: value }),
            Some(Self { low, high }) => Some(Self { low: low.min(value), high: high.max(value) }),
        })
    }

    /// A range that a user gave: in order, and wide enough to be drawn.
    pub(super) fn given(range: Option<(f64, f64)>) -> Option<Self> {
        let (first, second) = range?;
        let span = Self { low: first.min(second), high: first.max(second) };
        (first.is_finite() && second.is_finite()).then(|| span.readable())
    }

    /// Half the width, which is finite even where the width overflows.
    pub(super) fn half_width(self) -> f64 {
        self.high * 0.5 - self.low * 0.5
    }

    pub(super) fn contains(self, value: f64) -> bool {
        self.low <= value && value <= self.high
    }

    /// The range itself, or a wider one about it where rounding would merge its ends.
    pub(super) fn readable(self) -> Self {
        const SMALLEST: f64 = 1e-290;
        let largest = self.low.abs().max(self.high.abs());
        if self.half_width() > largest * 1e-13 && self.half_width() > SMALLEST {
            return self;
        }
        let centre = self.low * 0.5 + self.high * 0.5;
        let half = if centre == 0.0 { 1.0 } else { (centre.abs() * 0.1).max(10.0 * SMALLEST) };
        Self { low: (centre - half).max(f64::MIN), high: (centre + half).min(f64::MAX) }
    }

    /// The range with a share of its width added at either end.
    pub(super) fn padded(self, share: f64) -> Self {
        let room = self.half_width() * (2.0 * share);
        Self { low: (self.low - room).max(f64::MIN), high: (self.high + room).min(f64::MAX) }
    }

    /// The range with a share of its width added at the high end.
    pub(super) fn beyond(self, share: f64) -> Self {
        Self { low: self.low, ..self.padded(share) }
    }

    /// Position of the value in the range: 0 at the low end, 1 at the high end.
    ///
    /// Limited to a million widths, so that a far value keeps its direction and stays finite.
    pub(super) fn fraction(self, value: f64) -> f64 {
        ((value * 0.5 - self.low * 0.5) / self.half_width()).clamp(-1e6, 1e6)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_values_get_a_range_about_them() {
        for value in [0.0, 5.0, -3e-12, 1e300, f64::MAX, f64::MIN, 5e-324] {
            let span = Span::of([value, value]).unwrap().readable();
            assert!(span.low < span.high, "{value}: {span:?}");
            assert!(span.contains(value), "{value}: {span:?}");
            assert!(span.half_width().is_finite() && span.half_width() > 0.0);
        }
    }

    #[test]
    fn a_given_range_is_put_in_order_and_must_be_finite() {
        let span = Span::given(Some((2.0, -1.0))).unwrap();
        assert_eq!((span.low, span.high), (-1.0, 2.0));
        assert_eq!(Span::given(Some((f64::NAN, 1.0))), None);
        assert_eq!(Span::given(Some((0.0, f64::INFINITY))), None);
    }

    #[test]
    fn the_widest_range_still_places_a_value() {
        let span = Span::of([f64::MIN, f64::MAX]).unwrap().readable();
        assert_eq!(span.fraction(f64::MIN), 0.0);
        assert_eq!(span.fraction(0.0), 0.5);
        assert_eq!(span.fraction(f64::MAX), 1.0);
    }

    #[test]
    fn values_that_are_not_finite_are_ignored() {
        let span = Span::of([f64::NAN, 1.0, f64::INFINITY, 2.0]).unwrap();
        assert_eq!((span.low, span.high), (1.0, 2.0));
        assert_eq!(Span::of([f64::NAN]), None);
    }
}
