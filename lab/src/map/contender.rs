//! Who is on the map.

use std::fmt;
use std::str::FromStr;

use crate::compare::Settings;
use crate::scene::{Candidate, Lolc, Popc, Scene, Stabilizer, nearest};

/// A stabilizer of a map, by its name; work, ledger and damping cap are the scene's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Contender {
    /// No stabilizer: `none`.
    Nobody,
    /// The passivity observer/controller: `popc`.
    Popc,
    /// LOLC with the scene's own candidate, or the paper's if the scene names no LOLC: `lolc`.
    Lolc,
    /// LOLC with the spring candidate: `lolc-spring`.
    LolcSpring,
    /// LOLC with the device-damping candidate: `lolc-device-damping`.
    LolcDeviceDamping,
    /// LOLC with the paper's candidate: `lolc-mass-spring-damper`.
    LolcMassSpringDamper,
}

impl Contender {
    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::Nobody,
        Self::Popc,
        Self::Lolc,
        Self::LolcSpring,
        Self::LolcDeviceDamping,
        Self::LolcMassSpringDamper,
    ];

    /// Its name on the command line, in the table and in `map.json`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Nobody => "none",
            Self::Popc => "popc",
            Self::Lolc => "lolc",
            Self::LolcSpring => "lolc-spring",
            Self::LolcDeviceDamping => "lolc-device-damping",
            Self::LolcMassSpringDamper => "lolc-mass-spring-damper",
        }
    }

    /// What it is in `scene`.
    pub(super) fn on(self, scene: &Scene) -> Option<Stabilizer> {
        let Settings { work, ledger, damping_cap, .. } = Settings::of(scene);
        let lolc =
            |candidate| Some(Stabilizer::Lolc(Lolc { work, candidate, ledger, damping_cap }));
        match self {
            Self::Nobody => None,
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

impl fmt::Display for Contender {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A name that no stabilizer has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoContender(String);

impl fmt::Display for NoContender {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names = Contender::ALL.map(Contender::name);
        f.write_str("no stabilizer has that name\n  = ")?;
        match nearest(&self.0, &names) {
            Some(name) => write!(f, "did you mean `{name}`?"),
            None => write!(f, "the names are {}", names.join(", ")),
        }
    }
}

impl std::error::Error for NoContender {}

impl FromStr for Contender {
    type Err = NoContender;

    fn from_str(given: &str) -> Result<Self, NoContender> {
        let found = Self::ALL.into_iter().find(|one| one.name() == given);
        found.ok_or_else(|| NoContender(given.to_owned()))
    }
}
