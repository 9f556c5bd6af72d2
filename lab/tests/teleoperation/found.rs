//! Result of a hand-written run, beside the row of the comparison.

use approx::abs_diff_eq;
use lyapunov_lab::teleoperation::Score;

use crate::teleoperation::hand::{SURFACE, WALL};

/// Result of a run.
#[derive(Debug, Default)]
pub(super) struct Found {
    pub(super) master: Vec<f64>,
    pub(super) slave: Vec<f64>,
    pub(super) command: f64,
    pub(super) drift: f64,
    pub(super) energy: f64,
    pub(super) felt: f64,
    pub(super) felt_end: f64,
    pub(super) touch: Option<f64>,
    pub(super) given: f64,
    pub(super) kept: f64,
    pub(super) shortfall: f64,
    pub(super) active: [usize; 2],
}

impl Found {
    /// Checks the row of the comparison.
    #[track_caller]
    pub(super) fn equals(&self, score: &Score) {
        let last = self.master.len() - 1;
        let (x, y) = (self.master[last], self.slave[last]);
        let pairs = self.master.iter().zip(&self.slave);
        let error = pairs.map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
        let deepest = self.slave.iter().copied().fold(SURFACE, f64::max) - SURFACE;
        for (what, told, hand, size) in [
            ("energy", score.energy, 1e3 * self.energy, 1e3 * self.energy),
            ("error", score.error, 1e3 * error, 1e3 * error),
            ("error at the end", score.error_end, 1e3 * (x - y), 1e3 * error),
            ("drift", score.drift, 1e3 * self.drift, 1e3 * error),
            ("force felt", score.felt, self.felt, self.felt),
            ("force at the end", score.felt_end, self.felt_end, self.felt),
            ("contact", score.contact, WALL * deepest, WALL * deepest),
            ("given", score.given, 1e3 * self.given, 1.0 + 1e3 * self.given),
            ("shortfall", score.shortfall, 1e3 * self.shortfall, 1.0 + 1e3 * self.shortfall),
        ] {
            let told = told.unwrap();
            let near = (told - hand).abs() <= 1e-7 * size;
            assert!(near, "{what} of {}: {told}, {hand}", score.stabilizer);
        }
        assert_eq!(score.touch, self.touch, "{}", score.stabilizer);
        match score.kept {
            Some(kept) => {
                let (hand, size) = (1e3 * self.kept, 1.0 + 1e3 * self.kept.abs());
                assert!((kept - hand).abs() <= 1e-7 * size, "{}: {kept}", score.stabilizer);
            }
            None => assert_eq!(score.stabilizer, "two-layer"),
        }
        for (told, count) in [score.active_master, score.active_slave].into_iter().zip(self.active)
        {
            let share = 100.0 * count as f64 / self.master.len() as f64;
            // Where a correction is about the threshold, rounding decides whether it counts.
            assert!(
                abs_diff_eq!(told, share, epsilon = 0.1),
                "{}: {told}, {share}",
                score.stabilizer
            );
        }
    }
}
