//! Scene files, simulation, studies and their figures: what the command `lyapunov` is made of.
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

pub mod accuracy;
pub mod bounds;
mod building;
pub mod causes;
pub mod compare;
mod csv;
mod described;
mod equilibrium;
pub mod family;
pub mod hard;
mod html;
pub mod map;
mod meters;
pub mod models;
pub mod observe;
mod output_error;
pub mod paper;
mod prices;
mod quartiles;
mod rollout;
mod row;
pub mod scene;
pub mod shipped;
pub mod subjects;
mod summary;
mod table;
pub mod teleoperation;
mod tick;
mod timing;
mod words;

pub use self::csv::{COLUMNS, Csv};
pub use building::{AnyPlant, AnyStabilizer, Assembly, Port, Space};
#[doc(no_inline)]
pub use lyapunov_figures as figures;
#[doc(no_inline)]
pub use nalgebra::SVector;
pub use output_error::OutputError;
pub use prices::{Prices, PricesError};
pub use rollout::Rollout;
pub use row::{Row, further_columns, further_numbers};
pub use scene::{Render, Scene};
pub use summary::Summary;
pub use tick::{Apart, Tick};
