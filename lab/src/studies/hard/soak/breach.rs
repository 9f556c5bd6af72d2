//! A promise that a scene breaks.

use std::fmt;

use lyapunov::laws::Law;

use crate::measure::Verdict;

/// A promise that a scene breaks, and where.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Breach {
    /// A law of the port, first broken on this tick.
    Law {
        /// The kind of number that the loop ran in.
        numbers: &'static str,
        /// The law.
        law: Law,
        /// The tick.
        tick: u64,
    },
    /// A lane whose ticks are not those of its scalar run, bit for bit.
    Lane {
        /// The lane.
        lane: usize,
    },
    /// The measures of a map, which differ between a lane and its scalar run.
    Measures {
        /// The lane.
        lane: usize,
    },
    /// The energies of the plant by cause, which do not add up.
    Energies {
        /// The rest, J.
        rest: f64,
        /// The sum of the magnitudes of all energies moved, J.
        moved: f64,
    },
    /// The verdicts of a map and of `explain` on the same run.
    Verdicts {
        /// That of a map.
        map: Verdict,
        /// That of `explain`.
        explain: Verdict,
    },
    /// A loop that runs away in one of `f64` and `f32` and stays near in the other.
    RunsAway {
        /// The kind of number in which it runs away.
        numbers: &'static str,
    },
}

impl Breach {
    /// Whether it is the same promise that `other` breaks, at whichever tick.
    pub(super) fn is_like(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Law { numbers, law, .. }, Self::Law { numbers: others, law: another, .. }) => {
                (numbers, law) == (others, another)
            }
            _ => std::mem::discriminant(self) == std::mem::discriminant(other),
        }
    }
}

impl fmt::Display for Breach {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Law { numbers, law, tick } => write!(f, "in {numbers}, tick {tick}: {law}"),
            Self::Lane { lane } => write!(f, "lane {lane} must equal its scalar run bit for bit"),
            Self::Measures { lane } => {
                write!(f, "the measures of lane {lane} must equal those of its scalar run")
            }
            Self::Energies { rest, moved } => {
                write!(f, "the energies by cause must add up; {rest:e} J of {moved:e} J are left")
            }
            Self::Verdicts { map, explain } => {
                write!(f, "a run must have one verdict: a map says {map}, explain says {explain}")
            }
            Self::RunsAway { numbers } => {
                write!(f, "f64 and f32 must agree: the loop runs away in {numbers} only")
            }
        }
    }
}
