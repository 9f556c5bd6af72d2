//! Scene files, simulation, studies and their figures: what the command `lyapunov` is made of.
//!
//! The crate is a house of floors, and each knows only those below it: text, files, simulation, measures, how they are
//! shown, and on top the studies, a room for each command.
//!
//! A [`Rollout`] closes the loop that a [`Scene`] describes, with the scene's own stabilizer or with anybody
//! else's:
//!
//! ```
//! use lyapunov::{Correction, PortSample, Stabilizer};
//! use lyapunov_lab::{Rollout, Summary, paper};
//!
//! /// A damper that is always there, N·s/m.
//! struct Damper(f64);
//! impl Stabilizer<f64> for Damper {
//!     fn stabilize(&mut self, sample: &PortSample<f64>, effort: f64) -> Correction<f64> {
//!         Correction { alpha: self.0, ..Correction::none(effort + self.0 * sample.velocity) }
//!     }
//! }
//!
//! let scene = paper::Case::Plain8k.scene()?;
//! let summary = Summary::of(&scene, Rollout::stabilized_by(&scene, Damper(5.0))?);
//! assert!(summary.settled.is_some_and(|time| time < 2.0));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod files;
mod measure;
mod show;
mod simulate;
mod studies;
mod text;

// Files.
pub use files::scene::{self, Render, Scene};

/// Models of plants that are affine in their input, and the stabilizers of their ports side by side.
pub mod models {
    pub use crate::files::models::*;
    pub use crate::measure::models::{BOUND, Score};
    pub use crate::simulate::models::Entrant;
    pub use crate::studies::compare::models::Comparison;
}

/// Teleoperators, and what stabilizes them side by side.
pub mod teleoperation {
    pub use crate::files::teleoperation::*;
    pub use crate::measure::teleoperation::{BOUND, Curves, Score};
    pub use crate::simulate::teleoperation::Entrant;
    pub use crate::studies::compare::teleoperation::Comparison;
}

// Simulation.
pub use simulate::building::{AnyPlant, AnyStabilizer, Assembly, Port, Space};
pub use simulate::family;
pub use simulate::rollout::Rollout;
pub use simulate::row::{Row, further_columns, further_numbers};
pub use simulate::tick::{OperatorMotion, Tick};

// Measures, and how they are shown.
pub use measure::summary::Summary;
pub use show::csv::{COLUMNS, Csv};
pub use show::output_error::OutputError;

// Studies, one for each command.
pub use studies::{accuracy, bound, compare, effects, explain, hard, map, observe, paper, scenes};

// What other crates give to the names above.
#[doc(no_inline)]
pub use lyapunov_figures as figures;
#[doc(no_inline)]
pub use nalgebra::SVector;
