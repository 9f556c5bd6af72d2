//! The family of stabilizers by name, each with parameters from the scene.
//!
//! A [`StabilizerName`] names one; docs/family.md lists the parameters of each. `compare`, `map` and `hard` take the
//! same names, and so do the program's [own](crate::own). Stabilizers with two ends, or for several axes only, are not here.
//!
//! ```
//! use lyapunov_lab::{Rollout, Summary, family::StabilizerName, paper};
//!
//! let scene = paper::Case::Plain8k.scene()?;
//! let member: StabilizerName = "popc-bounded".parse()?;
//! let summary = Summary::of(&scene, Rollout::<f64>::under(&scene, member)?);
//! assert!(summary.settled.is_some() || summary.rows == 1001);
//! assert!("popc-bound".parse::<StabilizerName>().unwrap_err().to_string().contains("`popc-bounded`"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod basic_name;
mod judgement;
mod own_name;
mod settings;
mod stabilizer_name;
mod stabilizer_names;

pub use basic_name::BasicName;
pub use judgement::Judgement;
pub use own_name::OwnName;
pub use settings::Settings;
pub use stabilizer_name::{StabilizerName, UnknownStabilizer};
pub use stabilizer_names::{StabilizerNames, StabilizerNamesError};
