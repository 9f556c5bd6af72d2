//! Difference of a run from a log in one quantity.

use lyapunov::accumulators::{Accumulator, Compensated};
use serde::Serialize;

use crate::measure::Oddity;
use crate::measure::sanity::Sign;

/// Likeness of two forces below which one is the other with its sign turned.
const OPPOSITE: f64 = -0.9;

/// Difference of a run from a log in one quantity, run − log, over the rows of the log.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Difference {
    /// The unit of all but the shares.
    pub unit: &'static str,
    /// Root mean square of the difference.
    pub rms: f64,
    /// The difference of the largest magnitude, with its sign.
    pub largest: f64,
    /// The time of the largest on the scene's clock, s.
    pub largest_at_s: f64,
    /// The range of the quantity in the log: its highest value less its lowest.
    pub range: f64,
    /// The root mean square as a share of that range, %; none where the log's quantity never changes.
    pub rms_percent: Option<f64>,
    /// The magnitude of the largest likewise, %.
    pub largest_percent: Option<f64>,
}

/// Differences of a run from a log.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Differences {
    /// Of the position.
    pub position: Difference,
    /// Of the velocity.
    pub velocity: Difference,
    /// Of the force that acts until the next tick.
    pub force: Difference,
}

impl Differences {
    /// Each with its name.
    pub(super) fn named(&self) -> [(&'static str, &Difference); 3] {
        [("position", &self.position), ("velocity", &self.velocity), ("force", &self.force)]
    }
}

/// Sums over the rows of a log.
#[derive(Clone, Copy, Debug)]
pub(super) struct Meter {
    rows: u64,
    squares: Compensated<f64>,
    largest: f64,
    at: f64,
    low: f64,
    high: f64,
    /// `Σ l s`, `Σ l²` and `Σ s²` of log and run.
    products: [Compensated<f64>; 3],
}

impl Meter {
    pub(super) fn new() -> Self {
        let zero = Compensated::zero();
        Self {
            rows: 0,
            squares: zero,
            largest: 0.0,
            at: 0.0,
            low: f64::INFINITY,
            high: f64::NEG_INFINITY,
            products: [zero; 3],
        }
    }

    pub(super) fn add(&mut self, time: f64, log: f64, run: f64) {
        let difference = run - log;
        self.squares.add(difference * difference);
        if self.rows == 0 || difference.abs() > self.largest.abs() {
            (self.largest, self.at) = (difference, time);
        }
        (self.low, self.high) = (self.low.min(log), self.high.max(log));
        let [both, of_log, of_run] = &mut self.products;
        both.add(log * run);
        of_log.add(log * log);
        of_run.add(run * run);
        self.rows += 1;
    }

    pub(super) fn finish(self) -> Met {
        let rms = (self.squares.value() / self.rows.max(1) as f64).sqrt();
        let range = (self.high - self.low).max(0.0);
        let [both, of_log, of_run] = self.products.map(|sum| sum.value());
        let likeness = both / (of_log * of_run).sqrt();
        Met { rms, largest: self.largest, at: self.at, range, likeness }
    }
}

/// A difference in SI units.
#[derive(Clone, Copy, Debug)]
pub(super) struct Met {
    rms: f64,
    largest: f64,
    at: f64,
    range: f64,
    /// −1 for opposites, 1 for the same up to a factor; NaN where one is 0.
    likeness: f64,
}

impl Met {
    /// The difference in a unit of which `per` make an SI unit.
    pub(super) fn in_units(self, unit: &'static str, per: f64) -> Difference {
        let percent = |value: f64| (self.range > 0.0).then(|| 100.0 * value / self.range);
        Difference {
            unit,
            rms: per * self.rms,
            largest: per * self.largest,
            largest_at_s: self.at,
            range: per * self.range,
            rms_percent: percent(self.rms),
            largest_percent: percent(self.largest.abs()),
        }
    }

    /// The signs of the log alone, and that of a force that is the run's with its sign turned, where they do not tell it.
    pub(super) fn look_at(self, mut alone: Vec<Oddity>) -> Vec<Oddity> {
        let told =
            "the log's f is against the run's: its sign looks reversed (--scale f=-1 turns it)";
        let is_told = alone.iter().any(|it| it.sign == Sign::Reversed);
        if self.likeness <= OPPOSITE && !is_told {
            alone.push(Oddity::new(Sign::Reversed, told));
        }
        alone
    }
}
