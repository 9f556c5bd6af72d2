//! Curve of any length in little memory.

/// The number of stretches in a curve: more than a figure can show.
const STRETCHES: u64 = 8192;

/// Quantity over time, thinned to the extremes of each of some thousand stretches if there are more ticks.
#[derive(Clone, Debug)]
pub(crate) struct Trace {
    stretch: u64,
    count: u64,
    low: (f64, f64),
    high: (f64, f64),
    points: Vec<(f64, f64)>,
}

impl Trace {
    /// A curve of about `ticks` points.
    pub(crate) fn new(ticks: u64) -> Self {
        let stretch = ticks.div_ceil(STRETCHES).max(1);
        let unset = (0.0, 0.0);
        // Stretches of one or two points keep all of them.
        let stretch = if stretch <= 2 { 1 } else { stretch };
        Self { stretch, count: 0, low: unset, high: unset, points: Vec::new() }
    }

    pub(crate) fn add(&mut self, t: f64, y: f64) {
        if self.count == 0 || y < self.low.1 {
            self.low = (t, y);
        }
        if self.count == 0 || y > self.high.1 {
            self.high = (t, y);
        }
        self.count += 1;
        if self.count == self.stretch {
            self.end();
        }
    }

    /// The points so far.
    pub(crate) fn finish(mut self) -> Vec<(f64, f64)> {
        if self.count > 0 {
            self.end();
        }
        self.points
    }

    fn end(&mut self) {
        let (first, second) =
            if self.low.0 <= self.high.0 { (self.low, self.high) } else { (self.high, self.low) };
        self.points.push(first);
        if second != first {
            self.points.push(second);
        }
        self.count = 0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    type Points = Vec<(f64, f64)>;

    fn curve(ticks: u64) -> (Points, Points) {
        let all: Vec<(f64, f64)> =
            (0..=ticks).map(|n| (n as f64, (n as f64 * 0.37).sin() * n as f64)).collect();
        let mut trace = Trace::new(ticks);
        all.iter().for_each(|&(t, y)| trace.add(t, y));
        (all, trace.finish())
    }

    #[test]
    fn a_short_curve_is_kept_whole() {
        for ticks in [0, 1, 1000, 16_000] {
            let (all, kept) = curve(ticks);
            assert_eq!(all, kept);
        }
    }

    #[test]
    fn a_long_curve_keeps_its_extremes_in_order() {
        let (all, kept) = curve(1_000_000);
        assert!(kept.len() <= 2 * STRETCHES as usize);
        assert!(kept.windows(2).all(|pair| pair[0].0 < pair[1].0));
        let most = |points: &[(f64, f64)]| points.iter().map(|p| p.1).fold(f64::MIN, f64::max);
        let least = |points: &[(f64, f64)]| points.iter().map(|p| p.1).fold(f64::MAX, f64::min);
        assert_eq!((most(&all), least(&all)), (most(&kept), least(&kept)));
    }
}
