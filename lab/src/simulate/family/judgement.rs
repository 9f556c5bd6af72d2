//! Judgement that is fair to a stabilizer.

use serde::Serialize;

use super::{BasicName, StabilizerName};

/// Numbers by which a stabilizer is judged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Judgement {
    /// Settling, for a stabilizer that adds damping, and for none.
    Settling,
    /// The energy of port and device's damper, and the force felt. A law that adds no damping may bound a swing without
    /// ending it.
    EnergyAndForce,
}

impl Judgement {
    /// The numbers in words.
    pub(crate) fn words(self) -> &'static str {
        match self {
            Self::Settling => "settling",
            Self::EnergyAndForce => "energy and force",
        }
    }
}

impl StabilizerName {
    /// The judgement of this stabilizer.
    pub fn judgement(self) -> Judgement {
        match self {
            Self::ForceBound
            | Self::Tank
            | Self::EnergyBounding
            | Self::ForceBounding
            | Self::MemoryBased => Judgement::EnergyAndForce,
            Self::Basic(
                BasicName::NoStabilizer
                | BasicName::Popc
                | BasicName::Lolc
                | BasicName::LolcSpring
                | BasicName::LolcDeviceDamping
                | BasicName::LolcMassSpringDamper,
            )
            | Self::Budgeted
            | Self::Bounded
            | Self::Windowed
            | Self::ContactReset
            | Self::Threshold
            | Self::Spread
            | Self::RateLimited
            | Self::Rising
            | Self::Reference
            | Self::ReferenceFollowing
            | Self::LeastNorm => Judgement::Settling,
        }
    }
}
