//! Verdict of an ensemble on a claim.

use std::fmt;

use super::influence::Influence;

/// Least share of the members for which a reproduced claim holds, at the lower end of the interval.
const REPRODUCED: f64 = 0.95;
/// Largest share for which a claim that is not reproduced holds, at the upper end of the interval.
const NOT_REPRODUCED: f64 = 0.05;

/// Verdict of an ensemble on a claim.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// The lower end of the interval is above 95 %.
    Reproduced,
    /// The interval lies between 5 and 95 %: it depends on these constants, the strongest first; on none by itself if there are
    /// none.
    DependsOn(Vec<&'static str>),
    /// The interval holds 5 or 95 %.
    TooFew,
    /// The upper end of the interval is below 5 %.
    NotReproduced,
}

impl Verdict {
    pub(super) fn of([low, high]: [f64; 2], influences: &[Influence]) -> Self {
        if low > REPRODUCED {
            Self::Reproduced
        } else if high < NOT_REPRODUCED {
            Self::NotReproduced
        } else if low > NOT_REPRODUCED && high < REPRODUCED {
            Self::DependsOn(influences.iter().map(|influence| influence.constant).collect())
        } else {
            Self::TooFew
        }
    }

    /// The verdict without the constants that it names.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Reproduced => "reproduced",
            Self::DependsOn(_) => "depends",
            Self::TooFew => "too few draws",
            Self::NotReproduced => "not reproduced",
        }
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::DependsOn(constants) if constants.is_empty() => {
                f.write_str("depends on no single constant, as far as the draws show")
            }
            Self::DependsOn(constants) => write!(f, "depends on {}", constants.join(", ")),
            _ => f.write_str(self.word()),
        }
    }
}

impl serde::Serialize for Verdict {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}
