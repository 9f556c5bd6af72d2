//! Whether a run stays where it belongs.

use crate::Row;
use crate::equilibrium::{equilibrium, swing};
use crate::scene::Scene;
use crate::summary::BAND;

/// How much larger the last quarter's swing may be than the second's: what sampling the peaks of an undamped
/// swing may come to, and no more.
const GROWTH: f64 = 1.05;

/// How many times the starting swing is never bounded.
const REACH: f64 = 10.0;

/// Watches `e(n) = |x(n) − x_eq|`, the distance from where the operator's spring and the wall balance.
#[derive(Clone, Debug)]
pub(crate) struct Boundedness {
    equilibrium: Option<f64>,
    start: f64,
    last: u64,
    rows: u64,
    quarters: [f64; 4],
}

impl Boundedness {
    pub(crate) fn new(scene: &Scene) -> Self {
        let equilibrium = equilibrium(scene);
        let last = scene.ticks();
        Self { equilibrium, start: start(scene), last, rows: 0, quarters: [0.0; 4] }
    }

    pub(crate) fn add(&mut self, row: &Row) {
        let away = self.equilibrium.map_or(0.0, |rest| (row.x - rest).abs());
        let quarter = (4 * self.rows / (self.last + 1)).min(3) as usize;
        self.quarters[quarter] = self.quarters[quarter].max(away);
        self.rows += 1;
    }

    /// Whether the run was stable; none where no spring pulls the plant anywhere.
    pub(crate) fn verdict(&self) -> Option<bool> {
        let complete = self.rows == self.last + 1;
        if !complete || self.equilibrium.is_none() {
            return if complete { None } else { Some(false) };
        }
        let [_, second, _, end] = self.quarters;
        let widest = self.quarters.into_iter().fold(0.0, f64::max);
        let grows = end > (GROWTH * second).max(BAND * self.start);
        Some(!grows && widest <= REACH * self.start)
    }
}

/// The swing that a run is measured by, m: the starting one, or the spring's deflection at the equilibrium if
/// that is more, so that a start in balance is not measured by nothing.
pub(super) fn start(scene: &Scene) -> f64 {
    let deflection = |rest: f64| (scene.operator.rest.get() - rest).abs();
    equilibrium(scene).map_or(0.0, |rest| swing(scene, rest).max(deflection(rest)))
}

#[cfg(test)]
mod tests {
    use super::super::samples::{row, scene};
    use super::*;

    /// The verdict on a run of 101 rows at `x(t)`, equilibrium 0, starting swing 4 mm.
    fn verdict(scene: &Scene, rows: usize, x: impl Fn(f64) -> f64) -> Option<bool> {
        let mut meter = Boundedness::new(scene);
        (0..rows).for_each(|n| meter.add(&Row { x: x(n as f64 / 100.0), ..row() }));
        meter.verdict()
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
    fn growth_within_the_band_is_noise_and_a_far_cycle_is_no_bound() {
        let scene = scene("");
        assert_eq!(verdict(&scene, 101, |t| if t > 0.8 { 0.00019 } else { 0.0001 }), Some(true));
        assert_eq!(verdict(&scene, 101, |t| if t > 0.8 { 0.00021 } else { 0.0001 }), Some(false));
        assert_eq!(verdict(&scene, 101, |_| 0.0399), Some(true));
        assert_eq!(verdict(&scene, 101, |_| 0.0401), Some(false));
    }

    #[test]
    fn rows_that_end_early_are_unstable_and_without_a_spring_nothing_is_said() {
        assert_eq!(verdict(&scene(""), 100, |_| 0.0), Some(false));
        let loose = scene("operator.stiffness = 0.0\n");
        assert_eq!(verdict(&loose, 101, |t| t), None);
        assert_eq!(verdict(&loose, 100, |t| t), Some(false));
    }

    #[test]
    fn a_start_in_balance_is_measured_by_the_spring_s_deflection() {
        // 50 N/m pulling from 0 to 22 mm against 1 kN/m at 1 mm: balance at 2 mm, deflection 20 mm.
        let pressed = scene("operator.rest = 0.022\ninitial.position = 0.002\n");
        assert!((start(&pressed) - 0.020).abs() < 1e-12);
        assert!((start(&scene("")) - 0.004).abs() < 1e-12);
    }
}
