//! Good row of a log.

use super::bad::SHORTEST;

/// A good row, in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Sample {
    pub(crate) line: u64,
    pub(crate) t: f64,
    /// Time since the first good row, s: more digits are left of it than of the difference of two times.
    pub(crate) since: f64,
    pub(crate) x: f64,
    pub(crate) f: f64,
    pub(crate) v: Option<f64>,
}

impl Sample {
    /// True where `later` comes so long after this row that one may divide by the time between them.
    pub(crate) fn is_before(&self, later: &Self) -> bool {
        later.since - self.since >= SHORTEST
    }
}
