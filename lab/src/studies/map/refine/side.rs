//! Side of the edge of bounded runs that a cell lies on.

use crate::measure::Verdict;

/// Side of the edge of bounded runs: whether the run in a cell stays bounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Side {
    /// It settles or is swinging.
    Bounded,
    /// It grows.
    Grows,
    /// It is too short to judge.
    TooShort,
}

impl Side {
    /// All sides.
    pub const ALL: [Self; 3] = [Self::Bounded, Self::Grows, Self::TooShort];

    /// The side in words.
    pub fn word(self) -> &'static str {
        match self {
            Self::Bounded => "bounded",
            Self::Grows => "grows",
            Self::TooShort => "too short",
        }
    }
}

impl From<Verdict> for Side {
    fn from(verdict: Verdict) -> Self {
        match verdict {
            Verdict::Settles | Verdict::Swinging => Self::Bounded,
            Verdict::Grows => Self::Grows,
            Verdict::TooShort => Self::TooShort,
        }
    }
}
