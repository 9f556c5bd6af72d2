//! Measures along a run of a model.

use serde::Serialize;

use super::trace::Trace;
use super::verdict::{Findings, Verdict};
use crate::files::models::Model;
use crate::simulate::models::{Entrant, Tick};
use crate::text::names::Named;

/// The largest V of a run that does not grow, as a multiple of V at the start: 4, which is twice as far from rest where V
/// is quadratic.
pub const BOUND: f64 = 4.0;

/// The largest V in the last tenth of a run that settles, as a multiple of V at the start: a twentieth of the distance
/// from rest where V is quadratic.
///
/// A V that falls below 0 by more than that has no least value at rest, and says nothing about the distance from it.
pub const BAND: f64 = 0.0025;

/// The least number of answers of the controller in a run that is judged: the last tenth then has two.
const ANSWERS: u64 = 20;

/// All measures along a run.
#[derive(Debug)]
pub(crate) struct Meter {
    expected: u64,
    is_short: bool,
    servo_rate: f64,
    began: f64,
    ticks: u64,
    active: u64,
    largest: f64,
    least: f64,
    tail: f64,
    last: f64,
    effort: f64,
    shortfall: f64,
    taken: f64,
    trace: Trace,
}

impl Meter {
    /// The meter of a run of `model` that starts with V = `began`.
    pub(crate) fn new(model: &Model, began: f64) -> Self {
        let (last, servo_rate) = (model.ticks(), model.servo_rate.get());
        let answer =
            u64::from(model.controller.hold.get()) + u64::from(model.controller.delay.get());
        let (expected, is_short) = (last + 1, last < ANSWERS * answer);
        let trace = Trace::new(last);
        let (ticks, active) = (0, 0);
        let [largest, least, tail, last, effort, shortfall, taken] = [0.0; 7];
        Self {
            expected,
            is_short,
            servo_rate,
            began,
            ticks,
            active,
            largest,
            least,
            tail,
            last,
            effort,
            shortfall,
            taken,
            trace,
        }
    }

    pub(crate) fn add(&mut self, tick: Tick) {
        self.trace.add(self.ticks as f64 / self.servo_rate, tick.value);
        // The last tenth of the run, as of a scene.
        if 10 * self.ticks >= 9 * (self.expected - 1) {
            self.tail = self.tail.max(tick.value);
        }
        self.ticks += 1;
        self.active += u64::from(tick.alpha > 0.0);
        self.largest = self.largest.max(tick.value);
        self.least = self.least.min(tick.value);
        self.last = tick.value;
        self.effort = self.effort.max(tick.effort);
        self.shortfall = self.shortfall.max(tick.shortfall);
        // The force of the last tick acts after the run.
        self.taken += if self.ticks < self.expected { tick.taken } else { 0.0 };
    }

    pub(crate) fn finish(self, entrant: Entrant) -> Outcome {
        let complete = self.ticks == self.expected;
        let is_within = self.largest <= BOUND * self.began && self.least >= -BAND * self.began;
        let told = |value: f64| value.is_finite().then_some(value);
        let score = Score {
            stabilizer: entrant.name(),
            verdict: Verdict::of(Findings {
                is_lost: !complete || !is_within,
                is_short: self.is_short,
                grows: false,
                settles: self.tail <= BAND * self.began,
            }),
            largest: told(self.largest).filter(|_| complete),
            end: told(self.last).filter(|_| complete),
            effort: told(self.effort).filter(|_| complete),
            active: 100.0 * self.active as f64 / self.ticks.max(1) as f64,
            shortfall: told(self.shortfall),
            taken: told(self.taken),
        };
        Outcome { entrant, score, curve: self.trace.finish() }
    }
}

/// The result of one entrant on one model; docs/any-plant.md defines every number.
///
/// Numbers out of range are `None`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Score {
    /// The entrant.
    pub stabilizer: &'static str,
    /// The verdict on the run, by V: it grows beyond [`BOUND`] times V at the start, by a V below 0 or out of the range of
    /// the scalar, and settles within [`BAND`] of V at the start.
    pub verdict: Verdict,
    /// The largest V.
    #[serde(rename = "v_largest")]
    pub largest: Option<f64>,
    /// V at the last tick.
    #[serde(rename = "v_end")]
    pub end: Option<f64>,
    /// The largest size of the effort on the plant, over all inputs together.
    #[serde(rename = "effort_largest")]
    pub effort: Option<f64>,
    /// Share of the ticks on which damping was injected, percent.
    #[serde(rename = "active_percent")]
    pub active: f64,
    /// Largest debt that a tick could not serve.
    pub shortfall: Option<f64>,
    /// The energy that the stabilizer's part of the effort took from V.
    #[serde(rename = "energy_taken")]
    pub taken: Option<f64>,
}

/// The numbers of one entrant, and V over time.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Outcome {
    pub(crate) entrant: Entrant,
    pub(crate) score: Score,
    /// Time in s and V.
    pub(crate) curve: Vec<(f64, f64)>,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The verdict on a run of 100 ticks of which `V(n)` is known, under a controller of this delay.
    fn verdict(delay: u16, rows: u64, value: impl Fn(f64) -> f64) -> Verdict {
        let text = format!(
            "duration = 1.0\nservo_rate = 100.0\ninitial = [0.5, 0.0]\nplant.van-der-pol.mu = 1.0\n\
             controller.delay = {delay}\n"
        );
        let model = Model::parse(&text, "test").unwrap();
        let mut meter = Meter::new(&model, value(0.0));
        for row in 0..rows {
            let value = value(row as f64 / 100.0);
            meter.add(Tick { value, effort: 0.0, alpha: 0.0, shortfall: 0.0, taken: 0.0 });
        }
        meter.finish(Entrant::None).score.verdict
    }

    #[test]
    fn v_that_decays_stays_or_passes_its_bound_is_told_apart() {
        let exponential = |rate: f64| verdict(0, 101, move |t| 2.0 * (rate * t).exp());
        // At 0.9 s from a rate of ln(0.0025) / 0.9 s on within the band; at 1 s from ln 4 on beyond the bound.
        assert_eq!([-8.0, -6.66].map(exponential), [Verdict::Settles; 2]);
        assert_eq!([-6.65, 0.0, 1.38].map(exponential), [Verdict::Swinging; 3]);
        assert_eq!([1.39, 5.0].map(exponential), [Verdict::Grows; 2]);
        // Once beyond the bound is enough.
        let peak = |most: f64| {
            verdict(0, 101, move |t| if t == 0.5 { most } else { 1e-9 + (1.0 - t).floor() })
        };
        assert_eq!([3.99, 4.01].map(peak), [Verdict::Settles, Verdict::Grows]);
    }

    #[test]
    fn a_v_below_0_has_grown_unless_by_rounding() {
        let dips = |least: f64| verdict(0, 101, move |t| if t == 0.5 { least } else { 2.0 });
        assert_eq!(
            [-0.0049, -0.0051, -32.0].map(dips),
            [Verdict::Swinging, Verdict::Grows, Verdict::Grows]
        );
        let falls = |end: f64| verdict(0, 101, move |t| if t < 0.5 { 2.0 } else { end });
        assert_eq!(
            [-1e-9, -0.0051, -32.0].map(falls),
            [Verdict::Settles, Verdict::Grows, Verdict::Grows]
        );
    }

    #[test]
    fn a_run_of_few_answers_is_not_judged_unless_it_is_lost() {
        assert_eq!(
            [4, 5].map(|delay| verdict(delay, 101, |_| 1.0)),
            [Verdict::Swinging, Verdict::TooShort]
        );
        assert_eq!(verdict(5, 101, |t| 1.0 + 9.0 * t), Verdict::Grows);
        assert_eq!(verdict(5, 100, |_| 1.0), Verdict::Grows);
    }
}
