//! Stabilizer names that a scene file can use.

use lyapunov::{ParameterError, stabilizers::NoStabilizer};

use super::Settings;
use crate::files::scene::{Candidate, Draft, Lolc, Popc, Scene, Stabilizer};
use crate::simulate::building::{AnyStabilizer, Space};

/// Stabilizer that a scene file can name, or none; the scene sets work, ledger and damping cap.
///
/// Maps run these on lanes.
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

    /// The stabilizer setting under this name in `scene`.
    pub(crate) fn on(self, scene: &Draft) -> Option<Stabilizer> {
        let Settings { work, ledger, damping_cap, .. } = Settings::of(scene);
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

    /// The stabilizer itself on `scene`.
    pub(super) fn made<V: Space>(self, scene: &Scene) -> Result<AnyStabilizer<V>, ParameterError> {
        match self.on(scene) {
            None => Ok(AnyStabilizer::new(NoStabilizer)),
            Some(named) => AnyStabilizer::named(scene, named),
        }
    }
}
