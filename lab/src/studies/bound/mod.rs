//! Stiffness limits of a scene, by formula: `lyapunov bound`.
//!
//! [`Limits::of`] a scene holds them all; they are about its [`LinearPart`]. [`llewellyn`] is for two-ports, which
//! scenes do not have.
//!
//! ```
//! use lyapunov_lab::Scene;
//! use lyapunov_lab::bound::Limits;
//!
//! let text = "duration = 1\nservo_rate = 1000\ndevice = { mass = 0.2, damping = 0.1 }\n\
//!             environment.wall.stiffness = 150.0";
//! let limits = Limits::of(&Scene::parse(text, "wall")?);
//! // 2 b / T: the wall is within it, so that no passive hand makes the loop unstable.
//! assert!((limits.passive.unwrap() - 200.0).abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod document;
mod picture;
mod report;
mod table;

pub use crate::measure::linear::{NotLinear, VelocitySource, llewellyn};
pub use crate::measure::{Limits, LinearPart};
pub use picture::RadiusCurve;
pub use report::page;
