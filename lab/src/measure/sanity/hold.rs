//! Hold of a force: the motion tells whether it acts from its row until the next.

use super::fit::Fit;
use super::{Oddity, Sign};
use crate::files::log::Sample;
use crate::text::found;

/// Fewest rows in contact that say something.
const ROWS: u64 = 20;

/// Share of the jerk's variance up to which a held force may leave it unexplained, and no other course is looked at.
const LEFT: f64 = 0.01;

/// Most that another course of the force may leave unexplained to be told, as a share of what a held force leaves; where that is
/// an encoder's steps, another course leaves a third of it.
const BETTER: f64 = 0.1;

/// Slope of the jerk over the sum of the velocities from which on it is no motion of a mass: of an `f` that is `x` times a constant
/// the course in straight lines makes the errors of `x` anew, with a slope of 2.
const STEEP: f64 = 0.5;

/// Most by which steps in a row may differ, as a share.
const UNEVEN: f64 = 0.1;

/// Jerk of the motion beside the change of the force in three courses.
///
/// A hand's spring and dampers change little from step to step, so that the jerk in contact is the logged force's.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Hold {
    rows: [Option<Sample>; 3],
    /// Fits to a force held from its row on, to one in straight lines from row to row, and to one held until its row.
    fits: [Fit; 3],
}

impl Hold {
    /// Adds the next row of a log in which forces above `threshold`, N, are contact.
    pub(super) fn add(&mut self, next: &Sample, threshold: f64) {
        let [first, second, third] = self.rows;
        self.rows = [second, third, Some(*next)];
        let (Some(first), Some(second), Some(third)) = (first, second, third) else { return };
        let rows = [first, second, third, *next];
        let step = second.since - first.since;
        let is_even =
            |pair: &[Sample]| (pair[1].since - pair[0].since - step).abs() <= UNEVEN * step;
        let is_free = rows.iter().all(|row| row.f.abs() <= threshold);
        if is_free || !rows.windows(2).all(is_even) {
            return;
        }
        let speed =
            |at: usize| (rows[at + 1].x - rows[at].x) / (rows[at + 1].since - rows[at].since);
        let [before, at, after] = [0, 1, 2].map(speed);
        let [e, f, g, h] = rows.map(|row| row.f);
        // Over two steps a force in straight lines counts by 1, 4, 1.
        let courses = [3.0 * (g - e), h + 3.0 * (g - f) - e, 3.0 * (h - f)];
        for (fit, change) in self.fits.iter_mut().zip(courses) {
            fit.add(change, before + at + after, before - 2.0 * at + after);
        }
    }

    /// The sign of a force that is not held from its row on.
    pub(super) fn finish(&self) -> Option<Oddity> {
        let [held, lines, until] = self.fits.map(|fit| fit.left());
        let best = if until < lines { &self.fits[2] } else { &self.fits[1] };
        let is_mass = best.dependence().by_velocity.abs() < STEEP;
        if best.count() < ROWS || held < LEFT || lines.min(until) > BETTER * held || !is_mass {
            return None;
        }
        let seen = |course: &str, left: f64| {
            let [left, held] = [left, held].map(|it| found(100.0 * it));
            format!(
                "x moves as if f {course}: that leaves {left} % of the jerk in contact, and f held from its row on {held} %"
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
