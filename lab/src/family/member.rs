//! The names.

use std::fmt;
use std::str::FromStr;

use super::Contender;
use crate::scene::{nearest, shorten};

/// A stabilizer by its name.
///
/// All but those of [`Contender`] book held work in a plain sum, under the damping cap of the scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Member {
    /// One that a scene file can name, or none.
    Plain(Contender),
    /// POPC with what the environment stores at the start on its account: `popc-budgeted`.
    Budgeted,
    /// POPC that keeps a bounded credit: `popc-bounded`.
    Bounded,
    /// POPC whose credit runs out: `popc-windowed`.
    Windowed,
    /// POPC that enters each contact without credit: `popc-contact-reset`.
    ContactReset,
    /// POPC that corrects from a velocity on: `popc-threshold`.
    Threshold,
    /// POPC that pays a debt over several ticks: `popc-spread`.
    Spread,
    /// POPC whose correction grows slowly: `popc-rate-limited`.
    RateLimited,
    /// POPC whose correction rises when it engages: `popc-rising`.
    Rising,
    /// POPC whose energy follows what the environment stores: `popc-reference`.
    Reference,
    /// Forces that the device's damping can pay for: `force-bound`.
    ForceBound,
    /// An energy tank: `tank`.
    Tank,
}

impl Member {
    /// All of them.
    pub const ALL: [Self; 17] = [
        Self::Plain(Contender::Nobody),
        Self::Plain(Contender::Popc),
        Self::Plain(Contender::Lolc),
        Self::Plain(Contender::LolcSpring),
        Self::Plain(Contender::LolcDeviceDamping),
        Self::Plain(Contender::LolcMassSpringDamper),
        Self::Budgeted,
        Self::Bounded,
        Self::Windowed,
        Self::ContactReset,
        Self::Threshold,
        Self::Spread,
        Self::RateLimited,
        Self::Rising,
        Self::Reference,
        Self::ForceBound,
        Self::Tank,
    ];

    /// Its name, on the command line and in every table and file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Plain(contender) => contender.name(),
            Self::Budgeted => "popc-budgeted",
            Self::Bounded => "popc-bounded",
            Self::Windowed => "popc-windowed",
            Self::ContactReset => "popc-contact-reset",
            Self::Threshold => "popc-threshold",
            Self::Spread => "popc-spread",
            Self::RateLimited => "popc-rate-limited",
            Self::Rising => "popc-rising",
            Self::Reference => "popc-reference",
            Self::ForceBound => "force-bound",
            Self::Tank => "tank",
        }
    }

    /// One of those that a scene file can name, if it is one.
    pub fn contender(self) -> Option<Contender> {
        match self {
            Self::Plain(contender) => Some(contender),
            _ => None,
        }
    }
}

impl From<Contender> for Member {
    fn from(contender: Contender) -> Self {
        Self::Plain(contender)
    }
}

impl fmt::Display for Member {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A name that no stabilizer has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoMember {
    given: String,
}

impl fmt::Display for NoMember {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names = Member::ALL.map(Member::name);
        write!(f, "no stabilizer is called `{}`\n  = ", shorten(&self.given))?;
        if let Some(name) = nearest(&self.given, &names) {
            write!(f, "did you mean `{name}`?\n  = ")?;
        }
        f.write_str("the names are:")?;
        names.chunks(5).try_for_each(|names| write!(f, "\n    {}", names.join(", ")))
    }
}

impl std::error::Error for NoMember {}

impl FromStr for Member {
    type Err = NoMember;

    fn from_str(given: &str) -> Result<Self, NoMember> {
        let found = Self::ALL.into_iter().find(|one| one.name() == given);
        found.ok_or_else(|| NoMember { given: given.to_owned() })
    }
}
