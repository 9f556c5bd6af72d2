//! Verdict on a run: the one definition of the words that every command, figure and file uses.
//!
//! [docs/verdicts.md](../../../docs/verdicts.md) has the definitions for scenes, models and teleoperators.

use std::fmt;

use serde::{Serialize, Serializer};

use crate::simulate::Criterion;

/// The verdict on one run, which covers that run only.
///
/// The order is from best to worst, and a run without a verdict comes last.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// From nine tenths of the run on, the motion stays within its band.
    Settles,
    /// Neither of the others: it stays bounded and does not come to rest.
    Swinging,
    /// It leaves its bound or the range of the numbers, or is larger at the end than before.
    Grows,
    /// The run has too few swings or ticks to be judged.
    TooShort,
}

impl Verdict {
    /// All verdicts, in their order.
    pub const ALL: [Self; 4] = [Self::Settles, Self::Swinging, Self::Grows, Self::TooShort];

    /// The word.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Settles => "settles",
            Self::Swinging => "swinging",
            Self::Grows => "grows",
            Self::TooShort => "too short",
        }
    }

    /// Verdict with this word.
    pub(crate) fn of_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|verdict| verdict.word() == word)
    }

    /// Verdict on a run.
    pub(crate) fn of(run: Findings) -> Self {
        match run {
            Findings { is_lost: true, .. } => Self::Grows,
            Findings { is_short: true, .. } => Self::TooShort,
            Findings { grows: true, .. } => Self::Grows,
            Findings { settles: true, .. } => Self::Settles,
            _ => Self::Swinging,
        }
    }

    /// Whether the run is bounded; none if it is too short to judge.
    pub(crate) fn judged(self) -> Option<bool> {
        (self != Self::TooShort).then(|| self.is_bounded())
    }

    /// Whether the run settles or is swinging.
    pub const fn is_bounded(self) -> bool {
        matches!(self, Self::Settles | Self::Swinging)
    }
}

/// Answers that a verdict follows from, the first true one deciding.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Findings {
    /// The run left the range of the numbers, or its bound.
    pub(crate) is_lost: bool,
    /// It is too short to judge.
    pub(crate) is_short: bool,
    /// Its end is larger than what came before.
    pub(crate) grows: bool,
    /// Its end lies within the band.
    pub(crate) settles: bool,
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.word())
    }
}

impl Serialize for Verdict {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.word())
    }
}

/// Quantity that the motion of a scene is judged by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Yardstick {
    /// The distance from the equilibrium.
    Distance,
    /// The speed, where a scene has no equilibrium.
    Speed,
}

impl Yardstick {
    /// Yardstick of the runs with this criterion.
    pub(crate) fn of(criterion: &Criterion) -> Self {
        if criterion.place().is_some() { Self::Distance } else { Self::Speed }
    }

    /// The word.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Distance => "distance",
            Self::Speed => "speed",
        }
    }

    /// Yardstick with this word.
    pub(crate) fn of_word(word: &str) -> Option<Self> {
        [Self::Distance, Self::Speed].into_iter().find(|yardstick| yardstick.word() == word)
    }
}

impl Serialize for Yardstick {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.word())
    }
}
