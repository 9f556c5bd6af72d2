//! What a run came to.

use lyapunov::laws::Law;

/// What was measured of a run, one value at a time, beside the library.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tally {
    /// The first law that was broken, and on which tick.
    pub broken: Option<(Law, u64)>,
    /// The first tick on which an effort was not finite.
    pub not_finite: Option<u64>,
    /// The first tick on which energies came near the end of the scalar's range; from there the account is not judged.
    pub out_of_range: Option<u64>,
    /// How far from the rest the port was in the last quarter, m.
    pub late_swing: f64,
    /// How far from the rest the port was at all, m.
    pub swing: f64,
    /// The most that the port had given out beyond what it took and what is credited, J.
    pub given: f64,
    /// The largest shortfall told, J.
    pub shortfall: f64,
    /// The largest effort commanded or acting on one axis, N.
    pub peak_force: f64,
    /// The largest effort that applied on one axis, as the drives tell, N.
    pub acting: f64,
    /// The largest share of what the account may be off by.
    pub off: f64,
    /// The largest correction, as a share of what the limit allows at the velocity told.
    pub correction: f64,
    /// What a case measures in a way of its own.
    pub value: f64,
}

impl Default for Tally {
    fn default() -> Self {
        Self {
            broken: None,
            not_finite: None,
            out_of_range: None,
            late_swing: 0.0,
            swing: 0.0,
            given: 0.0,
            shortfall: 0.0,
            peak_force: 0.0,
            acting: 0.0,
            off: 0.0,
            correction: 0.0,
            value: 0.0,
        }
    }
}

impl Tally {
    /// Notes that `law` does not hold on `tick`, if none was broken before.
    pub(super) fn require(&mut self, law: Law, kept: bool, tick: u64) {
        if !kept && self.broken.is_none() {
            self.broken = Some((law, tick));
        }
    }

    /// The worse of two runs, number by number: what a sweep came to.
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
pub(super) fn larger(a: f64, b: f64) -> f64 {
    if a >= b || a.is_nan() { a } else { b }
}
