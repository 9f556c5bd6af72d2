//! Force and stiffness that a stabilizer renders over a map, and the cells that it breaks.

use crate::measure::Verdict;
use crate::measure::runs::Outcome;

/// Force and stiffness that a stabilizer renders over a map, with the energy that the port gave and the cells that broke.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rendered {
    /// Force felt over all judged cells, percent: at most 100 in each, and 0 where a cell grows or the
    /// environment gave no force. None where no cell was judged, or no stabilizer felt any force.
    pub percent: Option<f64>,
    /// Mean force felt over the measured cells, percent, at most 100 in each.
    pub force_felt: Option<f64>,
    /// Mean stiffness felt over the measured cells with a long contact, percent.
    pub stiffness_felt: Option<f64>,
    /// The most that the port had given in a measured cell, mJ.
    pub energy_given: Option<f64>,
    /// The most that the port had given beyond its device's damper in a measured cell, mJ.
    pub energy_given_beyond_damper: Option<f64>,
    /// Cells that are bounded without a stabilizer and grow under this one; none where `none` takes no part.
    pub broke: Option<u64>,
}

/// Sums over the cells of one stabilizer.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Tally {
    judged: u64,
    /// Of bounded cells.
    rendered: f64,
    force: Mean,
    stiffness: Mean,
    given: Option<f64>,
    beyond_damper: Option<f64>,
    broke: u64,
}

#[derive(Clone, Copy, Debug, Default)]
struct Mean {
    sum: f64,
    count: u64,
}

impl Mean {
    fn add(&mut self, value: Option<f64>) {
        self.sum += value.unwrap_or_default();
        self.count += u64::from(value.is_some());
    }

    fn value(self) -> Option<f64> {
        (self.count > 0).then(|| self.sum / self.count as f64)
    }
}

impl Tally {
    /// Adds the outcome of a cell, and the verdict on it `alone`, without a stabilizer.
    pub(super) fn add(&mut self, outcome: &Outcome, alone: Option<Verdict>) {
        let measures = &outcome.measures;
        let force = measures.force_felt.map(|percent| percent.clamp(0.0, 100.0));
        let bounded = outcome.verdict.judged();
        if bounded == Some(true) {
            self.rendered += force.unwrap_or_default();
        }
        self.judged += u64::from(bounded.is_some());
        self.broke += u64::from(alone.is_some_and(Verdict::is_bounded) && bounded == Some(false));
        self.force.add(force);
        self.stiffness.add(measures.stiffness_felt);
        largest(&mut self.given, measures.energy_given);
        largest(&mut self.beyond_damper, measures.energy_given_beyond_damper);
    }

    /// Whether any force was felt.
    pub(super) fn has_force(&self) -> bool {
        self.force.count > 0
    }

    /// The result; `has_force`: some stabilizer felt a force; `has_alone`: `none` takes part.
    pub(super) fn rendered(&self, has_force: bool, has_alone: bool) -> Rendered {
        let known = has_force && self.judged > 0;
        Rendered {
            percent: known.then(|| self.rendered / self.judged as f64),
            force_felt: self.force.value(),
            stiffness_felt: self.stiffness.value(),
            energy_given: self.given,
            energy_given_beyond_damper: self.beyond_damper,
            broke: has_alone.then_some(self.broke),
        }
    }
}

fn largest(most: &mut Option<f64>, value: Option<f64>) {
    *most = match (*most, value) {
        (Some(most), Some(value)) => Some(most.max(value)),
        (most, value) => most.or(value),
    };
}
