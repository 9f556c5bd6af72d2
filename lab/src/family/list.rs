//! Several names.

use std::fmt;
use std::ops::Deref;
use std::str::FromStr;

use super::{Contender, Member, NoMember};

/// Members in the order in which they are named, each once: `popc,tank`, or `all`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Members(Vec<Member>);

impl Members {
    /// No stabilizer, POPC, and LOLC with each of its candidates.
    pub fn standard() -> Self {
        let named = [
            Contender::Nobody,
            Contender::Popc,
            Contender::LolcSpring,
            Contender::LolcDeviceDamping,
            Contender::LolcMassSpringDamper,
        ];
        Self(named.map(Member::from).to_vec())
    }

    /// These.
    ///
    /// # Errors
    /// One that is there twice, or nobody at all.
    pub fn of(members: impl IntoIterator<Item = impl Into<Member>>) -> Result<Self, NoMembers> {
        let members: Vec<Member> = members.into_iter().map(Into::into).collect();
        let twice = members.iter().enumerate().find(|(at, it)| members[..*at].contains(it));
        match twice {
            Some((_, twice)) => Err(NoMembers::Twice(*twice)),
            None if members.is_empty() => Err(NoMembers::Nobody),
            None => Ok(Self(members)),
        }
    }
}

impl IntoIterator for Members {
    type Item = Member;
    type IntoIter = std::vec::IntoIter<Member>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}

impl Deref for Members {
    type Target = [Member];

    fn deref(&self) -> &[Member] {
        &self.0
    }
}

impl fmt::Display for Members {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names: Vec<&str> = self.iter().map(|member| member.name()).collect();
        f.write_str(&names.join(","))
    }
}

/// Why a text is no list of members.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoMembers {
    /// A name that nobody has.
    Unknown(NoMember),
    /// `all` beside a name.
    AllAndMore,
    /// A name that is there before.
    Twice(Member),
    /// Nobody.
    Nobody,
}

impl fmt::Display for NoMembers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown(error) => error.fmt(f),
            Self::AllAndMore => f.write_str(
                "`all` stands by itself\n  = leave the other names out, or name who is meant",
            ),
            Self::Twice(member) => {
                write!(f, "`{member}` is named twice\n  = name each stabilizer once")
            }
            Self::Nobody => f.write_str("no stabilizer is named\n  = name one at least"),
        }
    }
}

impl std::error::Error for NoMembers {}

impl FromStr for Members {
    type Err = NoMembers;

    fn from_str(given: &str) -> Result<Self, NoMembers> {
        if given == "all" {
            return Ok(Self(Member::ALL.to_vec()));
        }
        if given.split(',').any(|name| name == "all") {
            return Err(NoMembers::AllAndMore);
        }
        let named: Result<Vec<Member>, _> = given.split(',').map(str::parse).collect();
        Self::of(named.map_err(NoMembers::Unknown)?)
    }
}
