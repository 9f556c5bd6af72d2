//! Judgement that is fair to a stabilizer.

use serde::Serialize;

use super::StabilizerName;

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
    /// The word in JSON.
    pub(crate) fn word(self) -> &'static str {
        match self {
            Self::Settling => "settling",
            Self::EnergyAndForce => "energy-and-force",
        }
    }

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
        match self.adds_damping() {
            true => Judgement::Settling,
            false => Judgement::EnergyAndForce,
        }
    }

    /// Whether it takes energy out of a motion by a damper, and not only by smaller forces.
    pub fn adds_damping(self) -> bool {
        self.bare_table().is_none_or(|table| table.kind().adds_damping())
    }

    /// Whether the damping that it adds is reported as `α`.
    pub fn reports_damping(self) -> bool {
        self.bare_table().is_none_or(|table| table.kind().reports_damping())
    }
}
