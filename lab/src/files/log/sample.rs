//! Good row of a log.

use super::bad::{Reason, SHORTEST};

/// A good row, in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Sample {
    pub(crate) line: u64,
    pub(crate) t: f64,
    /// Time since the first good row, s: more digits are left of it than of the difference of two times.
    pub(crate) since: f64,
    pub(crate) x: f64,
    /// The force that acts from this row until the next.
    pub(crate) f: f64,
    /// The force that stands in this row: the same, unless it acts late.
    pub(crate) commanded: f64,
    pub(crate) v: Option<f64>,
}

impl Sample {
    /// The reason why `next` may not follow this row; none where it comes so long after that one may divide by the time between them.
    pub(crate) fn disorder(&self, next: &Self) -> Option<Reason<'static>> {
        let follows = next.since - self.since >= SHORTEST;
        (!follows).then_some(Reason::Order { time: next.t, last: self.t, line: self.line })
    }
}
