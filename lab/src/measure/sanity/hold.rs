//! Hold of a force: the motion tells whether it acts from its row until the next.

use super::fit::Fit;
use super::{Oddity, Sign};
use crate::files::log::Sample;
use crate::text::found;

/// Fewest rows in contact that say something.
const ROWS: u64 = 20;

/// Share of the change of velocity, as squares, that a held force may leave before another course is looked at.
const LEFT: f64 = 1e-4;

/// Share of that which another course of the force may leave to be told.
const BETTER: f64 = 0.5;

/// Most by which two steps may differ, as a share, for a held force to act over both alike.
const UNEVEN: f64 = 0.1;

/// Changes of velocity from step to step, beside the impulse of the force over both steps in three courses.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Hold {
    rows: [Option<Sample>; 2],
    /// Of a force held from its row on, of one in straight lines from row to row, and of one held until its row.
    fits: [Fit; 3],
}

impl Hold {
    /// Adds the next row of a log in which forces above `threshold`, N, are contact.
    pub(super) fn add(&mut self, after: &Sample, threshold: f64) {
        let [before, at] = self.rows;
        self.rows = [at, Some(*after)];
        let (Some(before), Some(at)) = (before, at) else { return };
        let forces = [before.f, at.f, after.f];
        let (first, second) = (at.since - before.since, after.since - at.since);
        let is_even = (second - first).abs() <= UNEVEN * first;
        if !is_even || forces.iter().all(|force| force.abs() <= threshold) {
            return;
        }
        let [came, went] = [(at.x - before.x) / first, (after.x - at.x) / second];
        let [f, g, h] = forces;
        // Two steps of a double integral weigh a force in straight lines by 1, 4, 1.
        for (fit, mean) in
            self.fits.iter_mut().zip([(f + g) / 2.0, (f + 4.0 * g + h) / 6.0, (g + h) / 2.0])
        {
            fit.add(mean, came + went, went - came);
        }
    }

    /// The sign of a force that is not held from its row on.
    pub(super) fn finish(&self) -> Option<Oddity> {
        let [held, lines, until] = self.fits.map(|fit| fit.left());
        if self.fits[0].count() < ROWS || held < LEFT || lines.min(until) > BETTER * held {
            return None;
        }
        let seen = |course: &str, left: f64| {
            let [left, held] = [left, held].map(|it| found(100.0 * it));
            format!(
                "x moves as if f {course}: that leaves {left} % of its changes of velocity in contact, and f held \
                 from its row on {held} %"
            )
        };
        let text = if until < lines {
            let seen = seen("acted until its row", until);
            format!("{seen}; log the force that acts from its row until the next")
        } else {
            let seen = seen("ran straight from row to row", lines);
            format!(
                "{seen}; the log has fewer rows than the loop has ticks, or the force is not held: log one row for each tick"
            )
        };
        Some(Oddity::new(Sign::Hold, text))
    }
}
