//! Boundedness of a run.

use lyapunov::Scalar;

use crate::simulate::Criterion;
use crate::simulate::equilibrium::BAND;

/// Largest ratio of the last quarter's swing to the second's in a bounded run: as much as sampling the peaks of an
/// undamped swing may amount to, and no more.
const GROWTH: f64 = 1.05;

/// The distance that is never bounded, as a multiple of the starting swing.
const REACH: f64 = 10.0;

/// Watches `e(n) = |x(n) − x_eq|`, the distance from where the operator's spring and the environment balance: its
/// largest value in each quarter of the run.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Boundedness<T> {
    last: u64,
    rows: u64,
    /// The row with which the next quarter begins, if there is one.
    next: u64,
    quarter: usize,
    /// The lowest and the highest position of this quarter: `e` is largest at one of them, whatever `x_eq` is.
    low: T,
    high: T,
    /// The positions of the quarters before.
    lows: [T; 4],
    highs: [T; 4],
}

impl<T: Scalar> Boundedness<T> {
    /// The meter of a run of the ticks 0 to `last`.
    pub(crate) fn new(last: u64) -> Self {
        let (low, high) = (T::of(f64::INFINITY), T::of(f64::NEG_INFINITY));
        let (lows, highs) = ([low; 4], [high; 4]);
        Self { last, rows: 0, next: start_of(1, last), quarter: 0, low, high, lows, highs }
    }

    #[inline(always)]
    pub(crate) fn add(&mut self, position: T) {
        if self.rows == self.next {
            self.turn();
        }
        self.low = position.smaller(self.low);
        self.high = position.larger(self.high);
        self.rows += 1;
    }

    /// Begins the quarter of this row.
    #[cold]
    #[inline(never)]
    fn turn(&mut self) {
        (self.lows[self.quarter], self.highs[self.quarter]) = (self.low, self.high);
        (self.low, self.high) = (T::of(f64::INFINITY), T::of(f64::NEG_INFINITY));
        while self.rows == self.next {
            self.quarter += 1;
            let next = self.quarter as u64 + 1;
            self.next = if next < 4 { start_of(next, self.last) } else { u64::MAX };
        }
    }

    /// Whether the run of a lane is already unstable, whatever follows.
    pub(crate) fn is_lost(&self, lane: usize, criterion: &Criterion) -> bool {
        let grows = || self.quarter == 3 && self.grows(lane, criterion);
        criterion.equilibrium.is_some() && (self.is_out(lane, criterion) || grows())
    }

    /// Whether the run of a lane was stable; none where no spring pulls the plant anywhere.
    pub(crate) fn verdict(&self, lane: usize, criterion: &Criterion) -> Option<bool> {
        let complete = self.rows == self.last + 1;
        if !complete || criterion.equilibrium.is_none() {
            return if complete { None } else { Some(false) };
        }
        Some(!self.grows(lane, criterion) && !self.is_out(lane, criterion))
    }

    fn grows(&self, lane: usize, criterion: &Criterion) -> bool {
        let [second, end] = [1, 3].map(|quarter| self.away(quarter, lane, criterion));
        end > (GROWTH * second).max(BAND * criterion.start)
    }

    fn is_out(&self, lane: usize, criterion: &Criterion) -> bool {
        let widest = (0..4).map(|quarter| self.away(quarter, lane, criterion)).fold(0.0, f64::max);
        widest > REACH * criterion.start
    }

    /// The largest `e` of a quarter. Rounding of a difference is monotonic, so this is the largest of all.
    fn away(&self, quarter: usize, lane: usize, criterion: &Criterion) -> f64 {
        let rest = criterion.equilibrium.unwrap_or_default();
        let (low, high) = match quarter == self.quarter {
            true => (self.low, self.high),
            false => (self.lows[quarter], self.highs[quarter]),
        };
        let (low, high) = (low.lane(lane), high.lane(lane));
        (high - rest).max(rest - low).max(0.0)
    }
}

/// The first row of a quarter, `ceil(quarter (last + 1) / 4)`.
fn start_of(quarter: u64, last: u64) -> u64 {
    (quarter * (last + 1)).div_ceil(4)
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;
    use crate::files::Scene;
    use crate::measure::samples::scene;

    /// The verdict on a run of 101 rows at `x(t)`, equilibrium 0, starting swing 4 mm.
    fn verdict(scene: &Scene, rows: usize, x: impl Fn(f64) -> f64) -> Option<bool> {
        let mut meter = Boundedness::new(scene.ticks());
        let criterion = Criterion::of(scene);
        (0..rows).for_each(|n| meter.add(x(n as f64 / 100.0)));
        let verdict = meter.verdict(0, &criterion);
        assert!(!meter.is_lost(0, &criterion) || verdict == Some(false));
        verdict
    }

    #[test]
    fn swings_that_shrink_or_stay_are_stable_and_those_that_grow_are_not() {
        let scene = scene("");
        let swing = |rate: f64| move |t: f64| 0.004 * (rate * t).exp() * (60.0 * t).cos();
        assert_eq!(verdict(&scene, 101, swing(-2.0)), Some(true));
        assert_eq!(verdict(&scene, 101, swing(0.0)), Some(true));
        assert_eq!(verdict(&scene, 101, swing(0.5)), Some(false));
        // Growth from a swing that had died away first.
        let again = |t: f64| 0.004 * (1.0 - 2.0 * t).abs() * (60.0 * t).cos();
        assert_eq!(verdict(&scene, 101, again), Some(false));
    }

    #[test]
    fn growth_within_the_band_is_noise_and_a_wide_cycle_is_unbounded() {
        let scene = scene("");
        assert_eq!(verdict(&scene, 101, |t| if t > 0.8 { 0.00019 } else { 0.0001 }), Some(true));
        assert_eq!(verdict(&scene, 101, |t| if t > 0.8 { 0.00021 } else { 0.0001 }), Some(false));
        assert_eq!(verdict(&scene, 101, |_| 0.0399), Some(true));
        assert_eq!(verdict(&scene, 101, |_| 0.0401), Some(false));
    }

    #[test]
    fn rows_that_end_early_are_unstable_and_without_a_spring_there_is_no_verdict() {
        assert_eq!(verdict(&scene(""), 100, |_| 0.0), Some(false));
        let loose = scene("operator.stiffness = 0.0\n");
        assert_eq!(verdict(&loose, 101, |t| t), None);
        assert_eq!(verdict(&loose, 100, |t| t), Some(false));
    }

    #[test]
    fn a_start_in_balance_is_measured_by_the_spring_s_deflection() {
        // 50 N/m pulling from 0 to 22 mm against 1 kN/m at 1 mm: balance at 2 mm, deflection 20 mm.
        let pressed = scene("operator.rest = 0.022\ninitial.position = 0.002\n");
        let start = |scene: &Scene| Criterion::of(scene).start;
        assert_abs_diff_eq!(start(&pressed), 0.020, epsilon = 1e-12);
        assert_abs_diff_eq!(start(&scene("")), 0.004, epsilon = 1e-12);
    }
}
