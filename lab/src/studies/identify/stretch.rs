//! Stretch of a log without a gap.

use std::ops::Range;

/// Rows of a log between two gaps, in SI units.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Stretch {
    pub(super) times: Vec<f64>,
    pub(super) positions: Vec<f64>,
    /// The force that acts from each row until the next.
    pub(super) forces: Vec<f64>,
    /// The velocities of the log; empty where it has none.
    pub(super) velocities: Vec<f64>,
}

impl Stretch {
    pub(super) fn len(&self) -> usize {
        self.times.len()
    }

    /// Some of its rows.
    pub(super) fn part(&self, rows: Range<usize>) -> Self {
        let part = |of: &[f64]| of.get(rows.clone()).map(<[f64]>::to_vec).unwrap_or_default();
        Self {
            times: part(&self.times),
            positions: part(&self.positions),
            forces: part(&self.forces),
            velocities: part(&self.velocities),
        }
    }
}

/// Roots of the weights: readings that stand still count once, however long they stand.
pub(super) fn weights(positions: &[f64]) -> Vec<f64> {
    let mut weights = Vec::with_capacity(positions.len());
    for run in positions.chunk_by(|one, other| one == other) {
        weights.extend(std::iter::repeat_n((run.len() as f64).sqrt().recip(), run.len()));
    }
    weights
}
