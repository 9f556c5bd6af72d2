//! List of stabilizer names.

use std::fmt;
use std::ops::Deref;
use std::str::FromStr;

use super::{BasicName, StabilizerName, UnknownStabilizer};
use crate::files::scene::Scene;

/// Stabilizer names in the order given, each once: `popc,tank`, or `all`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StabilizerNames(Vec<StabilizerName>);

impl StabilizerNames {
    /// No stabilizer, POPC, and LOLC with each of its candidates.
    pub fn standard() -> Self {
        let named = [
            BasicName::NoStabilizer,
            BasicName::Popc,
            BasicName::LolcSpring,
            BasicName::LolcDeviceDamping,
            BasicName::LolcMassSpringDamper,
        ];
        Self(named.map(StabilizerName::from).to_vec())
    }

    /// The list of these names.
    ///
    /// # Errors
    /// A name that appears twice, or an empty list.
    pub fn of(
        members: impl IntoIterator<Item = impl Into<StabilizerName>>,
    ) -> Result<Self, StabilizerNamesError> {
        let members: Vec<StabilizerName> = members.into_iter().map(Into::into).collect();
        let twice = members.iter().enumerate().find(|(at, it)| members[..*at].contains(it));
        match twice {
            Some((_, twice)) => Err(StabilizerNamesError::Twice(*twice)),
            None if members.is_empty() => Err(StabilizerNamesError::Empty),
            None => Ok(Self(members)),
        }
    }

    /// Entrants on `scene`: where all are named, those that it [has parameters for](StabilizerName::fits), else those
    /// that are named.
    #[must_use]
    pub fn on(&self, scene: &Scene) -> Self {
        let all = self.iter().copied().eq(StabilizerName::all());
        Self(self.iter().copied().filter(|name| !all || name.fits(scene)).collect())
    }
}

impl IntoIterator for StabilizerNames {
    type Item = StabilizerName;
    type IntoIter = std::vec::IntoIter<StabilizerName>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}

impl Deref for StabilizerNames {
    type Target = [StabilizerName];

    fn deref(&self) -> &[StabilizerName] {
        &self.0
    }
}

impl fmt::Display for StabilizerNames {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names: Vec<&str> = self.iter().map(|member| member.name()).collect();
        f.write_str(&names.join(","))
    }
}

/// Reason why a text is no list of stabilizer names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum StabilizerNamesError {
    /// A name that no stabilizer has.
    Unknown(UnknownStabilizer),
    /// `all` beside a name.
    AllAndMore,
    /// A name that appears twice.
    Twice(StabilizerName),
    /// No name at all.
    Empty,
}

impl fmt::Display for StabilizerNamesError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown(error) => error.fmt(f),
            Self::AllAndMore => f.write_str(
                "`all` stands by itself\n  = leave the other names out, or name who is meant",
            ),
            Self::Twice(member) => {
                write!(f, "`{member}` is named twice\n  = name each stabilizer once")
            }
            Self::Empty => f.write_str("no stabilizer is named\n  = name one at least"),
        }
    }
}

impl std::error::Error for StabilizerNamesError {}

impl FromStr for StabilizerNames {
    type Err = StabilizerNamesError;

    fn from_str(given: &str) -> Result<Self, StabilizerNamesError> {
        let names = || given.split(',').map(str::trim);
        if given == "all" {
            return Ok(Self(StabilizerName::all().collect()));
        }
        if names().any(|name| name == "all") {
            return Err(StabilizerNamesError::AllAndMore);
        }
        let named: Result<Vec<StabilizerName>, _> = names().map(str::parse).collect();
        Self::of(named.map_err(StabilizerNamesError::Unknown)?)
    }
}
