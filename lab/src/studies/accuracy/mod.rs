//! Accuracy against time: a scene under every propagator, step and scalar, against a far better reference.

mod document;
mod extrapolation;
mod horizon;
mod ledger;
mod picture;
mod reference;
mod report;
mod setting;
mod study;
mod table;
#[cfg(test)]
mod tests;
mod timing;
mod trace;

use std::fmt;

use lyapunov::{ParameterError, Requirement};

use crate::files::scene::{Conflict, Scene};

pub use ledger::LedgerRow;
pub use setting::{Number, Setting};
pub use study::{Row, Study};
pub use timing::Time;

/// Reason why there is no study.
#[derive(Clone, Debug, PartialEq)]
pub enum AccuracyError {
    /// A part of the scene cannot be made.
    Parameter(ParameterError),
    /// A reference's integrator cannot compute the scene.
    Scene(Conflict),
    /// The scene has more than one dimension.
    Space {
        /// The scene.
        scene: String,
    },
    /// `watch` ended the study.
    Stopped,
}

impl AccuracyError {
    /// The same with the key of `scene` that takes a part out of the range of a scalar.
    fn on(self, scene: &Scene) -> Self {
        match self {
            Self::Parameter(error) if error.requirement == Requirement::InRange => {
                // Whatever part finds it, the numbers that make the motion within a period are the cause.
                let motion = ParameterError { parameter: "mass", ..error };
                Self::Scene(scene.out_of_range(&motion, "a scalar of this study"))
            }
            other => other,
        }
    }
}

impl fmt::Display for AccuracyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Parameter(error) => error.fmt(f),
            Self::Scene(conflict) => conflict.fmt(f),
            Self::Space { scene } => {
                write!(f, "{scene}: [space] is not for this study\n  = ")?;
                f.write_str("study a scene of one dimension: axes of a plant move alike")
            }
            Self::Stopped => f.write_str("the study was stopped"),
        }
    }
}

impl std::error::Error for AccuracyError {}

impl From<Conflict> for AccuracyError {
    fn from(conflict: Conflict) -> Self {
        Self::Scene(conflict)
    }
}
