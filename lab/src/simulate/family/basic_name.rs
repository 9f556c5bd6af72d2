//! Names of the stabilizers that maps run on lanes.

use crate::files::scene::{Candidate, Cap, Draft, Lolc, Popc, Stabilizer};

use super::Settings;

/// Stabilizer that maps run on lanes: none, POPC, or LOLC with any candidate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BasicName {
    /// No stabilizer: `none`.
    NoStabilizer,
    /// The passivity observer/controller: `popc`.
    Popc,
    /// LOLC with the scene's own candidate, or with the paper's if the scene names no LOLC: `lolc`.
    Lolc,
    /// LOLC with the spring candidate: `lolc-spring`.
    LolcSpring,
    /// LOLC with the device-damping candidate: `lolc-device-damping`.
    LolcDeviceDamping,
    /// LOLC with the paper's candidate: `lolc-mass-spring-damper`.
    LolcMassSpringDamper,
}

impl BasicName {
    /// All names.
    pub const ALL: [Self; 6] = [
        Self::NoStabilizer,
        Self::Popc,
        Self::Lolc,
        Self::LolcSpring,
        Self::LolcDeviceDamping,
        Self::LolcMassSpringDamper,
    ];

    /// The name as text.
    pub fn name(self) -> &'static str {
        match self {
            Self::NoStabilizer => "none",
            Self::Popc => "popc",
            Self::Lolc => "lolc",
            Self::LolcSpring => "lolc-spring",
            Self::LolcDeviceDamping => "lolc-device-damping",
            Self::LolcMassSpringDamper => "lolc-mass-spring-damper",
        }
    }

    /// The table of the stabilizer under this name in `scene`, whose own table sets work, ledger and cap.
    pub(crate) fn table(self, scene: &Draft) -> Option<Stabilizer> {
        let Settings { work, ledger, .. } = Settings::of(scene);
        let damping_cap = scene.written_cap().and_then(|cap| Cap::new(cap).ok());
        let lolc =
            |candidate| Some(Stabilizer::Lolc(Lolc { work, candidate, ledger, damping_cap }));
        match self {
            Self::NoStabilizer => None,
            Self::Popc => Some(Stabilizer::Popc(Popc { work, ledger, damping_cap })),
            Self::Lolc => match scene.stabilizer {
                Some(Stabilizer::Lolc(own)) => lolc(own.candidate),
                _ => lolc(Candidate::MassSpringDamper),
            },
            Self::LolcSpring => lolc(Candidate::Spring),
            Self::LolcDeviceDamping => lolc(Candidate::DeviceDamping),
            Self::LolcMassSpringDamper => lolc(Candidate::MassSpringDamper),
        }
    }
}
