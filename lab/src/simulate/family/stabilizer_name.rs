//! Names of the stabilizers of the family.

use std::fmt;
use std::str::FromStr;

use super::BasicName;
use crate::files::scene::Scene;
use crate::text::{nearest, shorten};

/// Name of a stabilizer.
///
/// All except those of [`BasicName`] book held work in a plain ledger, under the damping cap of the scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StabilizerName {
    /// A stabilizer that a scene file can name, or none.
    Basic(BasicName),
    /// POPC credited with the energy that the environment stores at the start: `popc-budgeted`.
    Budgeted,
    /// POPC whose credit is bounded: `popc-bounded`.
    Bounded,
    /// POPC whose credit expires: `popc-windowed`.
    Windowed,
    /// POPC that enters each contact without credit: `popc-contact-reset`.
    ContactReset,
    /// POPC that corrects above a velocity threshold: `popc-threshold`.
    Threshold,
    /// POPC that spreads a debt over several ticks: `popc-spread`.
    Spread,
    /// POPC whose correction grows slowly: `popc-rate-limited`.
    RateLimited,
    /// POPC whose correction rises when it engages: `popc-rising`.
    Rising,
    /// POPC whose observed energy follows the energy that the environment stores: `popc-reference`.
    Reference,
    /// Bound on forces to what the device's damping can dissipate: `force-bound`.
    ForceBound,
    /// Energy tank: `tank`.
    Tank,
    /// Forces that hand back no more than the device's damping dissipates: `energy-bounding`.
    EnergyBounding,
    /// Forces that the device's damping has paid for in this contact: `force-bounding`.
    ForceBounding,
    /// Forces on the way out no larger than on the way in: `memory-based`.
    MemoryBased,
    /// POPC whose energy follows what the environment stores and dissipates: `reference-following`.
    ReferenceFollowing,
    /// The least correction that keeps the next observed energy at or above 0: `least-norm`.
    LeastNorm,
}

impl StabilizerName {
    /// All names.
    pub const ALL: [Self; 22] = [
        Self::Basic(BasicName::NoStabilizer),
        Self::Basic(BasicName::Popc),
        Self::Basic(BasicName::Lolc),
        Self::Basic(BasicName::LolcSpring),
        Self::Basic(BasicName::LolcDeviceDamping),
        Self::Basic(BasicName::LolcMassSpringDamper),
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
        Self::EnergyBounding,
        Self::ForceBounding,
        Self::MemoryBased,
        Self::ReferenceFollowing,
        Self::LeastNorm,
    ];

    /// The name on the command line and in every table and file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Basic(basic_name) => basic_name.name(),
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
            Self::EnergyBounding => "energy-bounding",
            Self::ForceBounding => "force-bounding",
            Self::MemoryBased => "memory-based",
            Self::ReferenceFollowing => "reference-following",
            Self::LeastNorm => "least-norm",
        }
    }

    /// Whether `scene` has the parameters of this stabilizer: energy bounding needs a damping of the device.
    pub fn fits(self, scene: &Scene) -> bool {
        self != Self::EnergyBounding || scene.device.damping.get() > 0.0
    }

    /// Whether it injects damping, and does not only change the environment's force.
    pub fn adds_damping(self) -> bool {
        !matches!(
            self,
            Self::ForceBound
                | Self::Tank
                | Self::EnergyBounding
                | Self::ForceBounding
                | Self::MemoryBased
        )
    }

    /// The basic name, if a scene file can name this stabilizer.
    pub fn basic_name(self) -> Option<BasicName> {
        match self {
            Self::Basic(basic_name) => Some(basic_name),
            _ => None,
        }
    }
}

impl From<BasicName> for StabilizerName {
    fn from(basic_name: BasicName) -> Self {
        Self::Basic(basic_name)
    }
}

impl fmt::Display for StabilizerName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// Name that no stabilizer has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownStabilizer {
    given: String,
}

impl fmt::Display for UnknownStabilizer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names = StabilizerName::ALL.map(StabilizerName::name);
        write!(f, "no stabilizer is called `{}`\n  = ", shorten(&self.given))?;
        if let Some(name) = nearest(&self.given, &names) {
            write!(f, "did you mean `{name}`?\n  = ")?;
        }
        f.write_str("the names are:")?;
        names.chunks(5).try_for_each(|names| write!(f, "\n    {}", names.join(", ")))
    }
}

impl std::error::Error for UnknownStabilizer {}

impl FromStr for StabilizerName {
    type Err = UnknownStabilizer;

    fn from_str(given: &str) -> Result<Self, UnknownStabilizer> {
        let found = Self::ALL.into_iter().find(|one| one.name() == given);
        found.ok_or_else(|| UnknownStabilizer { given: given.to_owned() })
    }
}
