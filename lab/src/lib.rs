//! Scene files, simulation, studies and their figures: the library behind the command `lyapunov`.
//!
//! The crate has six layers, and each uses only those below it: text, files, simulation, measures, their presentation,
//! and on top the studies, one for each command.
//!
//! A [`Rollout`] closes the loop that a [`Scene`] describes, with the scene's own stabilizer or with any other:
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

/// Control-affine plants, and the comparison of stabilizers at their ports.
pub mod models {
    pub use crate::files::models::*;
    pub use crate::measure::models::{BAND, BOUND, Score};
    pub use crate::simulate::models::Entrant;
    pub use crate::studies::compare::models::Comparison;
}

/// Teleoperators, and the comparison of their stabilizers.
pub mod teleoperation {
    pub use crate::files::teleoperation::*;
    pub use crate::measure::teleoperation::{BAND, BOUND, Curves, Score};
    pub use crate::simulate::teleoperation::Entrant;
    pub use crate::studies::compare::teleoperation::Comparison;
}

/// Own stabilizers and candidates among those that ship.
pub mod own {
    pub use crate::files::scene::own::{Allowed, Loop, OwnNumber, OwnTable, Promise, RosterError};
    #[doc(no_inline)]
    pub use crate::files::scene::{Search, Spacing};
    #[doc(inline)]
    pub use crate::simulate::own::*;
}

// Simulation.
pub use simulate::aligned::{Aligned, F64x8};
pub use simulate::building::{
    AnyPlant, AnyStabilizer, AnyWrapper, Assembly, Fitted, Port, Scenes, Space,
};
pub use simulate::ensemble::{Constant, Ensemble, Moves};
pub use simulate::family;
pub use simulate::rollout::Rollout;
pub use simulate::row::{Row, row_numbers};
pub use simulate::tick::{OperatorMotion, Tick};

// Measures and their presentation.
pub use measure::sanity::{Oddity, Sign};
pub use measure::summary::Summary;
pub use measure::verdict::{Verdict, Yardstick};
pub use show::csv::{COLUMNS, Csv};
pub use show::output_error::OutputError;
pub use show::row_file::{RowColumn, RowFile, Seeds};
pub use show::sync_folder::sync_folder;

// Studies, one for each command.
pub use studies::{
    accuracy, bound, compare, effects, explain, hard, identify, map, observe, paper, run, scenes,
    tune,
};

// Names of other crates that the interface above uses.
#[doc(no_inline)]
pub use text::{legible, shell_word};

pub use lyapunov_figures as figures;
#[doc(no_inline)]
pub use nalgebra::SVector;
