//! From one good row to the next.

use lyapunov::PortSample;

use super::log::Sample;

/// A time step of more than this many median periods is a gap.
pub(super) const GAP: f64 = 1.5;

/// From one good row to the next, bad rows in between or not.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step {
    pub(super) from: Sample,
    pub(super) to: Sample,
    /// The least and the largest force known to have applied meanwhile, N.
    pub(super) forces: (f64, f64),
    /// Whether there are bad rows in between.
    pub(super) spans: bool,
}

impl Step {
    /// Its length, s.
    pub(super) fn period(&self) -> f64 {
        self.to.t - self.from.t
    }

    /// Whether it is longer than a step should be.
    pub(super) fn is_gap(&self, median: f64) -> bool {
        self.period() > GAP * median
    }

    /// What the device did over the step, by the rule that guards keep (docs/contract.md): of all the forces that
    /// may have applied the one that did the least work, and over a gap of the two velocities, the measured one
    /// and the mean, the smaller. So no sum says more than was absorbed.
    pub(super) fn sample(&self, median: f64) -> PortSample<f64> {
        let Self { from, to, forces, .. } = self;
        let (period, displacement) = (self.period(), to.x - from.x);
        let mean = displacement / period;
        let velocity = match to.v {
            Some(measured)
                if (self.spans || self.is_gap(median)) && mean.abs() < measured.abs() =>
            {
                mean
            }
            Some(measured) => measured,
            None => mean,
        };
        let work = (forces.0 * displacement).min(forces.1 * displacement);
        PortSample { work, ..PortSample::new(period, to.x, velocity, displacement, from.f) }
    }
}

/// The steps that are longer than they should be.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
pub struct Gaps {
    /// How many there are: time steps longer than 1.5 median periods.
    pub count: u64,
    /// How many of them are over bad rows.
    pub over_bad_rows: u64,
    /// All their time, s.
    pub time: f64,
    /// The longest one.
    pub longest: Option<Gap>,
}

/// A step that is longer than it should be.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Gap {
    /// The line of the row before it.
    pub line: u64,
    /// When it begins, s.
    pub start: f64,
    /// How long it lasts, s.
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

/// The median period of steps, those over bad rows aside where there are others.
pub(super) fn median(steps: &[Step]) -> f64 {
    let sound = steps.iter().filter(|step| !step.spans).map(Step::period);
    let mut periods: Vec<f64> = sound.collect();
    if periods.is_empty() {
        periods = steps.iter().map(Step::period).collect();
    }
    let middle = periods.len() / 2;
    if periods.is_empty() {
        return 0.0;
    }
    *periods.select_nth_unstable_by(middle, f64::total_cmp).1
}
