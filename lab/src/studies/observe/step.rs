//! Step from one good row to the next.

use lyapunov::{HeldTick, PortSample, careful};

use crate::files::log::{Sample, TimeStep};

/// Step from one good row to the next, with or without bad rows in between.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step {
    pub(super) from: Sample,
    pub(super) to: Sample,
    /// The smallest and the largest force known to have been applied meanwhile, N.
    pub(super) forces: (f64, f64),
    /// Whether there are bad rows in between.
    pub(super) spans: bool,
}

impl Step {
    /// Its length, s.
    pub(super) fn period(&self) -> f64 {
        self.to.since - self.from.since
    }

    /// Its time alone.
    pub(super) fn time(&self) -> TimeStep {
        TimeStep { length: self.period(), spans: self.spans }
    }

    /// Sample of the device's motion over the step, by the rule of the guards (docs/contract.md): of all forces that
    /// may have been applied the one that did the least work, and over a gap the [`careful`] velocity. So no observed
    /// energy exceeds what was absorbed.
    pub(super) fn sample(&self, median: f64) -> PortSample<f64> {
        let Self { from, to, forces, .. } = self;
        let (period, displacement) = (self.period(), to.x - from.x);
        let mean = displacement / period;
        let is_gap = self.spans || self.time().is_gap(median);
        let velocity = to.v.map_or(mean, |it| if is_gap { careful(it, mean) } else { it });
        let work = (forces.0 * displacement).min(forces.1 * displacement);
        PortSample {
            work,
            ..HeldTick { period, position: to.x, velocity, displacement, applied: from.f }.sample()
        }
    }
}

/// The gaps of a log.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
pub struct Gaps {
    /// The number of gaps: time steps longer than 1.5 median periods.
    pub count: u64,
    /// The number of gaps over bad rows.
    pub over_bad_rows: u64,
    /// Total time of all gaps, s.
    pub time: f64,
    /// The longest gap.
    pub longest: Option<Gap>,
}

/// A gap: a time step that is too long.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Gap {
    /// The line of the row before it.
    pub line: u64,
    /// Its start, s.
    pub start: f64,
    /// Its length, s.
    pub length: f64,
}

impl Gaps {
    pub(super) fn add(&mut self, step: &Step) {
        self.count += 1;
        self.over_bad_rows += u64::from(step.spans);
        self.time += step.period();
        let gap = Gap { line: step.from.line, start: step.from.t, length: step.period() };
        if self.longest.is_none_or(|longest| gap.length > longest.length) {
            self.longest = Some(gap);
        }
    }
}
