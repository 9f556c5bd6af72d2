//! The candidate whose decrease the observer of a log sums.

use lyapunov::{Dissipation, LyapunovCandidate, PortEnergy, PortSample, candidates::InContact};
use serde::Serialize;

use crate::files::log::{LARGEST, LogError};
use crate::text::given;

/// The candidate whose decrease is summed, in the words of scene files.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[serde(tag = "name", rename_all = "kebab-case")]
pub enum Candidate {
    /// The port's energy alone: the passivity observer.
    #[default]
    Spring,
    /// Credits what the device's own damper must have dissipated, `b v² T` on every row.
    DeviceDamping {
        /// `b`, N·s/m.
        damping: f64,
    },
    /// Credits `b v² T` beyond a surface, as the paper's example 2 does.
    MassSpringDamper {
        /// `b`, N·s/m.
        damping: f64,
        /// The position of the surface, m; beyond it is `x > surface`.
        surface: f64,
    },
}

impl Candidate {
    /// The words that name candidates.
    pub const NAMES: [&'static str; 3] = ["spring", "device-damping", "mass-spring-damper"];

    /// The candidate called `word`, with the numbers that it takes: a damping in N·s/m, the position of a surface in m.
    ///
    /// # Errors
    /// A word that names none; a number too few or too many.
    pub fn named(word: &str, damping: Option<f64>, surface: Option<f64>) -> Result<Self, LogError> {
        let unused = |number: &str| {
            let problem = format!("the {number} means nothing to the candidate {word}");
            Err(LogError::new(problem).with_help("leave it out, or choose another candidate"))
        };
        let missing = |number: &str, example: &str| {
            let problem = format!("the candidate {word} needs a {number}");
            Err(LogError::new(problem).with_help(format!("add one, such as {example}")))
        };
        match (word, damping, surface) {
            ("spring", None, None) => Ok(Self::Spring),
            ("spring", Some(_), _) => unused("damping"),
            ("spring", ..) | ("device-damping", _, Some(_)) => unused("surface"),
            ("device-damping", Some(damping), None) => Ok(Self::DeviceDamping { damping }),
            ("device-damping", ..) => missing("damping", "--damping 0.1 (N.s/m)"),
            ("mass-spring-damper", Some(damping), Some(surface)) => {
                Ok(Self::MassSpringDamper { damping, surface })
            }
            ("mass-spring-damper", None, _) => missing("damping", "--damping 2 (N.s/m)"),
            ("mass-spring-damper", ..) => missing("surface", "--surface 0 (m)"),
            _ => Err(LogError::new(format!("there is no candidate `{word}`"))
                .with_help(format!("the candidates are {}", Self::NAMES.join(", ")))),
        }
    }

    /// The candidate with its parameters checked.
    pub(super) fn checked(self) -> Result<Credited, LogError> {
        let damper = |damping| match Dissipation::of(damping) {
            Ok(damper) if damping <= LARGEST => Ok(damper),
            _ => Err(LogError::new(format!("the damping is {} N.s/m", given(damping)))
                .with_help("give a damping from 0 to 1e50 N.s/m")),
        };
        Ok(match self {
            Self::Spring => Credited::Nothing,
            Self::DeviceDamping { damping } => Credited::Always(damper(damping)?),
            Self::MassSpringDamper { damping, surface } if surface.is_finite() => {
                Credited::InContact(damper(damping)?.gated(InContact { position: surface }))
            }
            Self::MassSpringDamper { surface, .. } => {
                return Err(LogError::new(format!("the surface is at {surface} m"))
                    .with_help("give its position as a finite number"));
            }
        })
    }

    /// Its name in a scene file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Spring => "spring",
            Self::DeviceDamping { .. } => "device-damping",
            Self::MassSpringDamper { .. } => "mass-spring-damper",
        }
    }
}

/// The port's energy with the candidate's credit.
#[derive(Clone, Copy, Debug)]
pub(super) enum Credited {
    Nothing,
    Always(Dissipation<f64>),
    InContact(Dissipation<f64, InContact<f64>>),
}

impl Credited {
    /// The credit over a sample, J.
    pub(super) fn credit(&mut self, sample: &PortSample<f64>) -> f64 {
        match self {
            Self::Nothing => 0.0,
            Self::Always(damper) => damper.decrease(sample),
            Self::InContact(damper) => damper.decrease(sample),
        }
    }
}

impl LyapunovCandidate<f64> for Credited {
    fn decrease(&mut self, sample: &PortSample<f64>) -> f64 {
        PortEnergy.decrease(sample) + self.credit(sample)
    }
}
