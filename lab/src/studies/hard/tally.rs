//! Measurements of a run.

use lyapunov::laws::Law;

/// Measurements of a run, one value at a time, made outside of the library.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Tally {
    /// The first broken law and its tick.
    pub broken: Option<(Law, u64)>,
    /// The first tick on which an effort was not finite.
    pub not_finite: Option<u64>,
    /// The first tick on which energies came near the end of the scalar's range; from it on the ledger is not judged.
    pub out_of_range: Option<u64>,
    /// The largest distance of the port from the rest in the last quarter, m.
    pub late_swing: f64,
    /// The largest distance of the port from the rest in the whole run, m.
    pub swing: f64,
    /// The largest energy that the port gave out beyond what it absorbed and what is credited, J.
    pub given: f64,
    /// The largest reported shortfall, J.
    pub shortfall: f64,
    /// The largest corrected effort on one axis, N.
    pub peak_force: f64,
    /// The largest applied effort on one axis, as the samples report it, N.
    pub acting: f64,
    /// The largest error of the ledger, as a share of what is allowed.
    pub off: f64,
    /// The largest correction, as a share of what the limit allows at the sample's velocity.
    pub correction: f64,
    /// The value that a case measures itself.
    pub value: f64,
}

impl Tally {
    /// Records `law` as broken on `tick` unless it was kept or another law was broken before.
    pub(super) fn require(&mut self, law: Law, kept: bool, tick: u64) {
        if !kept && self.broken.is_none() {
            self.broken = Some((law, tick));
        }
    }

    /// The worse of two runs, number by number.
    pub(super) fn worse(self, other: Self) -> Self {
        Self {
            broken: self.broken.or(other.broken),
            not_finite: self.not_finite.or(other.not_finite),
            out_of_range: self.out_of_range.or(other.out_of_range),
            late_swing: larger(self.late_swing, other.late_swing),
            swing: larger(self.swing, other.swing),
            given: larger(self.given, other.given),
            shortfall: larger(self.shortfall, other.shortfall),
            peak_force: larger(self.peak_force, other.peak_force),
            acting: larger(self.acting, other.acting),
            off: larger(self.off, other.off),
            correction: larger(self.correction, other.correction),
            value: larger(self.value, other.value),
        }
    }
}

/// The larger of two numbers, where NaN is larger than any.
#[inline]
pub(super) fn larger(a: f64, b: f64) -> f64 {
    if a >= b || a.is_nan() { a } else { b }
}
