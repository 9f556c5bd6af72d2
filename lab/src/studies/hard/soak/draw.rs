//! Random numbers of a case.

use lyapunov::effects::{Random, Source};

/// Calls that a case may make, far more than it does.
const CALLS: u64 = 1 << 20;

/// Random numbers of a case: the same for the same seed and case, whatever else is drawn.
#[derive(Debug)]
pub(super) struct Draw(Random<f64>);

impl Draw {
    /// The numbers of case `case` under `seed`.
    pub(super) fn of(seed: u64, case: u64) -> Self {
        let random = Random::new(|_| seed, Source::Ensemble);
        Self(random.from_call(case.wrapping_mul(CALLS)))
    }

    /// A number in `[from, to)`.
    pub(super) fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.0.uniform()
    }

    /// A number with as much room in each power of ten from `10^from` to `10^to`.
    pub(super) fn decades(&mut self, from: f64, to: f64) -> f64 {
        libm::pow(10.0, self.between(from, to))
    }

    /// A whole number from 0, below `end`.
    pub(super) fn below(&mut self, end: u32) -> u32 {
        self.between(0.0, end.into()) as u32
    }

    /// Whether something of this probability happens.
    pub(super) fn chance(&mut self, probability: f64) -> bool {
        self.between(0.0, 1.0) < probability
    }

    /// One of several.
    pub(super) fn pick<T: Copy>(&mut self, from: &[T]) -> T {
        from[self.below(from.len() as u32) as usize]
    }
}
