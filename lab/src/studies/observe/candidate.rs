//! The candidate whose decrease the observer of a log sums.

use lyapunov::{Dissipation, LyapunovCandidate, PortEnergy, PortSample, candidates::InContact};
use serde::Serialize;

use super::bad::LARGEST;
use super::error::ObserveError;

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
    /// The candidate with its parameters checked.
    pub(super) fn checked(self) -> Result<Credited, ObserveError> {
        let damper = |damping| match Dissipation::of(damping) {
            Ok(damper) if damping <= LARGEST => Ok(damper),
            _ => Err(ObserveError::new(format!("the damping is {damping} N.s/m"))
                .with_help("give a damping from 0 to 1e50 N.s/m")),
        };
        Ok(Credited(match self {
            Self::Spring => Credit::None,
            Self::DeviceDamping { damping } => Credit::Always(damper(damping)?),
            Self::MassSpringDamper { damping, surface } if surface.is_finite() => {
                Credit::InContact(damper(damping)?.gated(InContact { position: surface }))
            }
            Self::MassSpringDamper { surface, .. } => {
                return Err(ObserveError::new(format!("the surface is at {surface} m"))
                    .with_help("give its position as a finite number"));
            }
        }))
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
pub(super) struct Credited(Credit);

#[derive(Clone, Copy, Debug)]
enum Credit {
    None,
    Always(Dissipation<f64>),
    InContact(Dissipation<f64, InContact<f64>>),
}

impl Credited {
    /// The credit over a sample, J.
    pub(super) fn credit(&mut self, sample: &PortSample<f64>) -> f64 {
        match &mut self.0 {
            Credit::None => 0.0,
            Credit::Always(damper) => damper.decrease(sample),
            Credit::InContact(damper) => damper.decrease(sample),
        }
    }
}

impl LyapunovCandidate<f64> for Credited {
    fn decrease(&mut self, sample: &PortSample<f64>) -> f64 {
        PortEnergy.decrease(sample) + self.credit(sample)
    }
}
