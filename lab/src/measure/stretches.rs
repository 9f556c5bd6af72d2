//! Extremes of a signal over the stretches of a run.

use std::ops::Range;

use lyapunov::Scalar;

/// Number of stretches: the quarters of a run, the last of them divided where its last tenth begins.
const COUNT: usize = 5;

/// The second quarter.
pub(crate) const SECOND: Range<usize> = 1..2;

/// The last quarter, in its two stretches.
pub(crate) const LAST_QUARTER: Range<usize> = 3..5;

/// The last tenth.
pub(crate) const LAST_TENTH: Range<usize> = 4..5;

/// The whole run.
pub(crate) const ALL: Range<usize> = 0..COUNT;

/// The first half.
pub(crate) const EARLY: Range<usize> = 0..2;

/// Watches the lowest and the highest value of a signal in each stretch of a run.
///
/// A signal that recurs is compared over whole cycles: where a cycle is longer than a quarter, the last cycle takes the place of the
/// last quarter and the one before that of the second; where it is longer than a tenth, it takes the place of the last tenth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stretches<T> {
    last: u64,
    /// The ticks in which the signal recurs; 0 if it does not.
    cycle: u64,
    rows: u64,
    /// The row with which the next stretch begins, if there is one.
    next: u64,
    stretch: usize,
    /// The extremes of this stretch.
    low: T,
    high: T,
    /// The extremes of the stretches before.
    lows: [T; COUNT],
    highs: [T; COUNT],
}

/// The extremes of some rows of one stretch.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Span<T> {
    low: T,
    high: T,
}

impl<T: Scalar> Span<T> {
    #[inline(always)]
    pub(crate) fn add(&mut self, value: T) {
        self.low = value.smaller(self.low);
        self.high = value.larger(self.high);
    }

    /// The largest magnitude.
    #[inline(always)]
    pub(crate) fn reach(&self) -> T {
        self.high.magnitude().larger(self.low.magnitude())
    }
}

impl<T: Scalar> Stretches<T> {
    /// The meter of a run of the ticks 0 to `last`.
    pub(crate) fn new(last: u64) -> Self {
        Self::recurring(last, 0)
    }

    /// The same of a signal that recurs in `cycle` ticks.
    pub(crate) fn recurring(last: u64, cycle: u64) -> Self {
        let (low, high) = (T::of(f64::INFINITY), T::of(f64::NEG_INFINITY));
        let (lows, highs) = ([low; COUNT], [high; COUNT]);
        let next = start_of(1, last, cycle);
        Self { last, cycle, rows: 0, next, stretch: 0, low, high, lows, highs }
    }

    #[inline(always)]
    pub(crate) fn add(&mut self, value: T) {
        if self.rows == self.next {
            self.turn();
        }
        let mut span = self.span();
        span.add(value);
        self.take(span, 1);
    }

    /// Begins the stretch of the next row, where it is its first. Returns how many rows are left in it; in the last one,
    /// more than any run has.
    pub(crate) fn room(&mut self) -> u64 {
        if self.rows == self.next {
            self.turn();
        }
        self.next - self.rows
    }

    /// The extremes of the stretch so far, for more rows of it.
    #[inline(always)]
    pub(crate) fn span(&self) -> Span<T> {
        Span { low: self.low, high: self.high }
    }

    /// Takes the extremes of the stretch after as many more `rows`.
    #[inline(always)]
    pub(crate) fn take(&mut self, span: Span<T>, rows: u64) {
        (self.low, self.high) = (span.low, span.high);
        self.rows += rows;
    }

    /// Begins the stretch of this row.
    #[cold]
    #[inline(never)]
    fn turn(&mut self) {
        (self.lows[self.stretch], self.highs[self.stretch]) = (self.low, self.high);
        (self.low, self.high) = (T::of(f64::INFINITY), T::of(f64::NEG_INFINITY));
        while self.rows == self.next {
            self.stretch += 1;
            let next = self.stretch + 1;
            self.next = match next < COUNT {
                true => start_of(next, self.last, self.cycle),
                false => u64::MAX,
            };
        }
    }

    /// Whether the run has come to its end.
    pub(crate) fn is_complete(&self) -> bool {
        self.rows == self.last + 1
    }

    /// Whether the last quarter has begun.
    pub(crate) fn is_late(&self) -> bool {
        self.stretch >= LAST_QUARTER.start
    }

    /// The lowest and the highest value of a lane over some stretches; infinities where there is none.
    pub(crate) fn extremes(&self, stretches: Range<usize>, lane: usize) -> [f64; 2] {
        let [mut lowest, mut highest] = [f64::INFINITY, f64::NEG_INFINITY];
        // A stretch to come has no extremes yet.
        for stretch in stretches.start..stretches.end.min(self.stretch + 1) {
            let (low, high) = match stretch == self.stretch {
                true => (self.low, self.high),
                false => (self.lows[stretch], self.highs[stretch]),
            };
            lowest = lowest.min(low.lane(lane));
            highest = highest.max(high.lane(lane));
        }
        [lowest, highest]
    }
}

/// The first row of quarter `index`.
fn quarter(index: u64, last: u64) -> u64 {
    (index * (last + 1)).div_ceil(4)
}

/// Whether the second or the last quarter of a run is shorter than a cycle.
pub(crate) fn exceeds_quarter(last: u64, cycle: u64) -> bool {
    let [first, second, third] = [1, 2, 3].map(|index| quarter(index, last));
    cycle > (second - first).min(last + 1 - third)
}

/// Whether the last tenth of a run is shorter than a cycle.
pub(crate) fn exceeds_tenth(last: u64, cycle: u64) -> bool {
    cycle > last + 1 - (9 * last).div_ceil(10)
}

/// The first row of a stretch: `ceil(q (last + 1) / 4)` of quarter `q` and `ceil(9 last / 10)` of the last tenth, or an earlier
/// one where a whole cycle would not fit in from there on.
fn start_of(stretch: usize, last: u64, cycle: u64) -> u64 {
    let end = (last + 1).saturating_sub(cycle);
    match (stretch, exceeds_quarter(last, cycle)) {
        (4, _) => (9 * last).div_ceil(10).max(quarter(3, last)).min(end),
        (3 | 2, true) => end,
        (1, true) => end.saturating_sub(cycle),
        (index, _) => quarter(index as u64, last),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every stretch of every short run, against the extremes of the rows that belong to it.
    #[test]
    fn the_stretches_are_the_quarters_and_the_last_tenth() {
        for last in 0..60_u64 {
            let mut meter = Stretches::<f64>::new(last);
            for row in 0..=last {
                assert!(!meter.is_complete());
                meter.add(row as f64);
            }
            assert!(meter.is_complete());
            let rows = |from: f64, to: f64| -> [f64; 2] {
                let within = |row: &f64| (from..to).contains(&(row / (last + 1) as f64));
                let rows = (0..=last).map(|row| row as f64).filter(within);
                rows.fold([f64::INFINITY, f64::NEG_INFINITY], |all, row| {
                    [all[0].min(row), all[1].max(row)]
                })
            };
            assert_eq!(meter.extremes(SECOND, 0), rows(0.25, 0.5), "{last}");
            assert_eq!(meter.extremes(LAST_QUARTER, 0), rows(0.75, 1.0), "{last}");
            assert_eq!(meter.extremes(ALL, 0), [0.0, last as f64]);
            for cycle in 0..=last.div_ceil(2) {
                let mut meter = Stretches::<f64>::recurring(last, cycle);
                (0..=last).for_each(|row| meter.add(row as f64));
                let length = |stretches| {
                    let [low, high] = meter.extremes(stretches, 0);
                    (high - low + 1.0).max(0.0) as u64
                };
                let least = if last >= 20 { 1.max(cycle) } else { cycle };
                assert!(length(LAST_QUARTER) >= least && length(SECOND) >= least, "{last} {cycle}");
                assert!(length(LAST_TENTH) >= least, "{last} {cycle}");
                assert!(meter.extremes(SECOND, 0)[1] < meter.extremes(LAST_QUARTER, 0)[0]);
                if last >= 20 {
                    assert_eq!(meter.extremes(LAST_TENTH, 0)[1], last as f64);
                }
                if cycle <= (last + 1) / 4 && last >= 3 {
                    assert_eq!(meter.extremes(SECOND, 0), rows(0.25, 0.5), "{last} {cycle}");
                }
            }
            if last >= 20 {
                let start = (0..=last).find(|row| 10 * row >= 9 * last).unwrap();
                assert_eq!(meter.extremes(LAST_TENTH, 0), [start as f64, last as f64], "{last}");
            }
        }
    }
}
