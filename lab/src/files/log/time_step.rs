//! Time step of a log.

/// Length of a time step, in median periods, above which it is a gap.
pub(crate) const GAP: f64 = 1.5;

/// Time step from one good row to the next.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TimeStep {
    /// Its length, s.
    pub(crate) length: f64,
    /// Presence of bad rows in between.
    pub(crate) spans: bool,
}

impl TimeStep {
    /// True where it is longer than [`GAP`] median periods.
    pub(crate) fn is_gap(self, median: f64) -> bool {
        self.length > GAP * median
    }
}

/// Median length of `steps`, s; those over bad rows count only if there are no others. 0 without a step.
pub(crate) fn median_period(steps: impl Iterator<Item = TimeStep> + Clone) -> f64 {
    let length = |step: TimeStep| step.length;
    let mut periods: Vec<f64> = steps.clone().filter(|step| !step.spans).map(length).collect();
    if periods.is_empty() {
        periods = steps.map(length).collect();
    }
    periods.sort_unstable_by(f64::total_cmp);
    let middle = |index: usize| periods.get(index).copied().unwrap_or(0.0);
    f64::midpoint(middle(periods.len().saturating_sub(1) / 2), middle(periods.len() / 2))
}
