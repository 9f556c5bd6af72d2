//! Scene of a recorded log: `lyapunov identify`.
//!
//! [`identify`] fits mass, damping, spring and wall of a scene to a log of time, position and force, and tells each number with a
//! 95 % interval. docs/identify.md has the equations, and what a log cannot tell.
//!
//! ```
//! use std::fmt::Write;
//! use lyapunov_lab::identify::{Settings, identify};
//!
//! // 0.2 kg fall onto a wall of 500 N/m at 2 mm, at 1 kHz.
//! let (mut log, mut x, mut v) = (String::from("t,x,f\n"), 0.0, 0.2);
//! for n in 0..200 {
//!     let force = if x > 0.002 { 500.0 * (x - 0.002) } else { 0.0 };
//!     writeln!(log, "{},{x},{force}", 1e-3 * f64::from(n))?;
//!     (x, v) = (x + 1e-3 * v - 0.5e-6 * force / 0.2, v - 1e-3 * force / 0.2);
//! }
//! let identified = identify(log.as_bytes(), "fall.csv", &Settings::default())?;
//! assert!((identified.report.mass.value - 0.2).abs() < 1e-6);
//! assert!((identified.report.wall.unwrap().stiffness.value - 500.0).abs() < 1e-3);
//! println!("{}", identified.scene);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod alone;
mod base;
mod blocks;
mod device;
mod estimate;
mod feedback;
mod least_squares;
mod motion;
mod notes;
mod page;
mod picture;
mod plant;
mod recording;
mod replay;
mod report;
mod scene;
mod stretch;
mod text;
mod wall;

use std::io::Read;

pub use alone::Alone;
pub use estimate::Estimate;
pub use recording::Recording;
pub use report::{Report, Residual, WallReport};

use crate::files::log::{Columns, LogError, Scale};
use device::Device;
use replay::Replay;
use wall::Wall;

/// Settings for reading a log.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Settings {
    /// The columns of time, position, force and velocity.
    pub columns: Columns,
    /// Factors to SI units; those of the same column multiply.
    pub scales: Vec<Scale>,
    /// Mass and damping of the device without the hand, as far as they are known.
    pub alone: Alone,
}

/// Result of fitting a scene to a log.
#[derive(Clone, Debug)]
pub struct Identified {
    /// The numbers, with intervals and notes.
    pub report: Report,
    /// The scene, as TOML that is ready to run.
    pub scene: String,
    recording: Recording,
    device: Device,
    wall: Option<Wall>,
    replay: Option<Replay>,
}

/// Reads the log called `name` to its end and fits a scene to it.
///
/// # Errors
/// A log without the requested columns, one that is too long or too short, one that is not moved by its force, and a stream
/// that fails.
pub fn identify(log: impl Read, name: &str, settings: &Settings) -> Result<Identified, LogError> {
    Identified::of(Recording::read(log, name, settings)?, name, settings.alone)
}

impl Identified {
    /// Fits a scene to the recording of the log called `name`, on a device of which some is known `alone`.
    ///
    /// # Errors
    /// A recording that is not moved by its force; a device alone that is below 0 or above the sum that was fitted.
    pub fn of(recording: Recording, name: &str, alone: Alone) -> Result<Self, LogError> {
        let device = Device::of(&recording)
            .map_err(|fault| fault.about(name, recording.gaps, &recording.bad_rows))?;
        let wall = Wall::of(&recording.stretches, device.fitted(), device.lag(), device.unsure());
        let mut report = Report::of(name, &recording, &device, wall.as_ref());
        alone.check(&report)?;
        report.notes.extend(alone.note());
        let scene = scene::toml(&report, alone, recording.origin);
        let replay = Replay::of(&scene, &recording);
        report.replayed = replay.as_ref().map(|it| it.error);
        Ok(Self { report, scene, recording, device, wall, replay })
    }
}
