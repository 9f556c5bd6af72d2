//! What is measured along a run.

use super::contestant::Contestant;
use super::outcome::{Outcome, Score};
use crate::compare::Trace;

/// How many times V may become what it was at the start in a run that counts as bounded: 4, which is twice as far from
/// rest where V is quadratic.
pub const BOUND: f64 = 4.0;

/// One tick of a run.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tick {
    /// V.
    pub(super) value: f64,
    /// The size of the effort that acts from this tick on.
    pub(super) effort: f64,
    /// The damping injected.
    pub(super) alpha: f64,
    /// The debt that could not be served.
    pub(super) shortfall: f64,
    /// What the stabilizer's part of the effort takes from V until the next tick.
    pub(super) taken: f64,
}

/// Everything that is measured along a run.
#[derive(Debug)]
pub(super) struct Meter {
    expected: u64,
    servo_rate: f64,
    began: f64,
    ticks: u64,
    active: u64,
    largest: f64,
    last: f64,
    effort: f64,
    shortfall: f64,
    taken: f64,
    trace: Trace,
}

impl Meter {
    /// The meter of a run of `ticks` + 1 ticks that starts with V = `began`.
    pub(super) fn new(ticks: u64, servo_rate: f64, began: f64) -> Self {
        let expected = ticks + 1;
        let trace = Trace::new(ticks);
        let (ticks, active) = (0, 0);
        let [largest, last, effort, shortfall, taken] = [0.0; 5];
        Self {
            expected,
            servo_rate,
            began,
            ticks,
            active,
            largest,
            last,
            effort,
            shortfall,
            taken,
            trace,
        }
    }

    /// Ticks so far.
    pub(super) fn ticks(&self) -> u64 {
        self.ticks
    }

    pub(super) fn add(&mut self, tick: Tick) {
        self.trace.add(self.ticks as f64 / self.servo_rate, tick.value);
        self.ticks += 1;
        self.active += u64::from(tick.alpha > 0.0);
        self.largest = self.largest.max(tick.value);
        self.last = tick.value;
        self.effort = self.effort.max(tick.effort);
        self.shortfall = self.shortfall.max(tick.shortfall);
        // The force of the last tick acts beyond the run.
        self.taken += if self.ticks < self.expected { tick.taken } else { 0.0 };
    }

    pub(super) fn finish(self, contestant: Contestant) -> Outcome {
        let complete = self.ticks == self.expected;
        let told = |value: f64| value.is_finite().then_some(value);
        let score = Score {
            stabilizer: contestant.name(),
            bounded: complete && self.largest <= BOUND * self.began,
            largest: told(self.largest).filter(|_| complete),
            end: told(self.last).filter(|_| complete),
            effort: told(self.effort).filter(|_| complete),
            active: 100.0 * self.active as f64 / self.ticks.max(1) as f64,
            shortfall: told(self.shortfall),
            taken: told(self.taken),
        };
        Outcome { contestant, score, curve: self.trace.finish() }
    }
}
