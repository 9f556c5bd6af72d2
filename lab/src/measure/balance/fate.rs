//! Verdict on a run: bounded or not.

use crate::files::Scene;
use crate::measure::boundedness::Boundedness;
use crate::simulate::{Criterion, Space, Tick};

/// Largest ratio of the last quarter's speed to the second's in a bounded run: that of the swings in [`Boundedness`].
const GROWTH: f64 = 1.05;

/// A quarter slower than this share of the first is at rest.
const REST: f64 = 0.05;

/// Watches whether a run is bounded: as `lyapunov compare` judges it, and by its velocities where that gives no verdict
/// because no spring pulls the plant anywhere.
#[derive(Clone, Debug)]
pub(crate) struct Fate {
    criterion: Criterion,
    swing: Boundedness<f64>,
    last: u64,
    ticks: u64,
    quarters: [f64; 4],
}

impl Fate {
    pub(crate) fn new(scene: &Scene) -> Self {
        let (criterion, last) = (Criterion::of(scene), scene.ticks());
        Self { criterion, swing: Boundedness::new(last), last, ticks: 0, quarters: [0.0; 4] }
    }

    pub(crate) fn add<V: Space>(&mut self, tick: &Tick<V>) {
        self.swing.add(tick.truth.position.axis(0));
        let quarter = (4 * self.ticks / (self.last + 1)).min(3) as usize;
        self.quarters[quarter] = self.quarters[quarter].max(tick.measured.velocity.axis(0).abs());
        self.ticks += 1;
    }

    /// Whether the run is bounded.
    pub(crate) fn is_bounded(&self) -> bool {
        let [first, second, _, end] = self.quarters;
        let complete = self.ticks == self.last + 1;
        let swing = self.swing.verdict(0, &self.criterion);
        swing.unwrap_or(complete && end <= (GROWTH * second).max(REST * first))
    }
}
