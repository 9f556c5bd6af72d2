//! Scene files: what is simulated, for how long and under which stabilizer, as TOML in SI units.
//!
//! [`Scene::load`] reads a file and [`Scene::parse`] a text; both give either a scene in which every rule holds, or one
//! [`Diagnostic`] that names the key, its place, the value given and what would be right.
//!
//! The text is read in two steps. The `toml` crate turns it into a tree that knows the place of every key; a
//! deserializer of this module's own then hands that tree to serde. The alternative, `toml::from_str`, reports a
//! fault as a sentence in serde's words, from which key, value and remedy would have to be guessed back.
//!
//! A rule about one value lives in the type of that value ([`Positive`], [`NonNegative`], [`Finite`], [`Cap`],
//! [`DelayTicks`] and so on); the rules between values live in [`Scene::check`].
//!
//! ```
//! use lyapunov_lab::scene::Scene;
//!
//! let text = "
//! duration = 1.0
//! servo_rate = 1000.0
//! device.mass = 0.2
//! environment.wall.stiffness = 8000.0
//! ";
//! let scene = Scene::parse(text, "wall.toml")?;
//! assert_eq!(scene.ticks(), 1000);
//!
//! let fault = Scene::parse(&text.replace("stiffness", "stifness"), "wall.toml").unwrap_err();
//! assert_eq!(fault.key(), Some("environment.wall.stifness"));
//! assert_eq!(fault.line(), Some(5));
//! assert!(fault.to_string().contains("did you mean `stiffness`?"));
//! # Ok::<(), lyapunov_lab::scene::Diagnostic>(())
//! ```

mod book;
mod check;
mod choice;
mod coordinates;
mod damping;
mod diagnostic;
mod document;
mod effects;
mod environments;
mod excerpt;
mod explain;
mod fault;
mod integrator;
mod keys;
mod load;
mod motion;
mod number;
mod operator;
mod parts;
mod quantity;
mod reader;
mod rules;
mod schema;
mod stabilizer;
mod suggest;
mod syntax;
#[cfg(test)]
pub(crate) mod tests;
mod written;

pub(crate) use book::{Book, Key, key};
pub use check::Conflict;
pub(crate) use check::{check_single, check_ticks};
pub use coordinates::Coordinates;
pub(crate) use damping::Damping;
pub use diagnostic::Diagnostic;
pub(crate) use document::read;
pub use effects::{
    Delay, Dropout, Effects, Encoder, Filter, Friction, Jitter, Load, Noise, Policy, Pulse,
    Saturation,
};
pub use environments::*;
pub(crate) use excerpt::{printable, shorten};
pub use integrator::Integrator;
pub(crate) use keys::{BOOK, number_keys, unit};
pub(crate) use load::{MODEL, TELEOPERATOR, parse_at, text_of};
pub use operator::{Grip, Motion, Operator};
pub use parts::{Device, Initial, Link, Scalar, Space, Velocity};
pub use quantity::{
    Cap, DelayTicks, Dimensions, Finite, HoldTicks, NonNegative, OutOfRange, Positive, Probability,
    Seed, StepsPerTick, WindowTicks,
};
pub(crate) use quantity::{of, two};
pub(crate) use schema::schema_of;
pub use schema::{schema, schema_text};
pub use stabilizer::{Candidate, Ledger, Lolc, Popc, Stabilizer, Work};
pub(crate) use suggest::nearest;

use std::path::Path;

use serde::{Deserialize, Serialize};

use written::Keys;

/// One simulated run: two bodies that move as one, an environment at the port, at most one stabilizer, and the effects
/// of the sampled loop.
///
/// [`Scene::parse`] and [`Scene::load`] give only scenes that pass [`Scene::check`]. Whoever changes a field afterwards
/// calls it again before the derived quantities are used.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Keys", into = "Keys")]
pub struct Scene {
    /// Simulated time in s, greater than 0; required.
    pub duration: Positive,
    /// Rate of the servo loop in Hz, greater than 0; required.
    pub servo_rate: Positive,
    /// Rate at which the environment is evaluated in Hz, the servo rate divided by a whole number; default: the servo
    /// rate.
    pub environment_rate: Option<Positive>,
    /// How the loop obtains the velocity; default: backward difference.
    pub velocity: Velocity,
    /// Number type the run computes in; default: f64.
    pub scalar: Scalar,
    /// How the plant moves between two ticks; default: exact.
    pub integrator: Integrator,
    /// The operator's hand; default: all zero.
    pub operator: Operator,
    /// The haptic device; required.
    pub device: Device,
    /// What joins the two; default: they move as one.
    pub link: Option<Link>,
    /// The space that the scene is in; default: a line.
    pub space: Option<Space>,
    /// State of the plant at t = 0; default: at rest at 0.
    pub initial: Initial,
    /// What the device touches, exactly one; required.
    pub environment: Environment,
    /// What keeps the loop bounded; default: none.
    pub stabilizer: Option<Stabilizer>,
    /// Imperfections of the loop; default: none.
    pub effects: Effects,
}

impl Scene {
    /// Reads a scene from TOML text; `name` stands for the text in messages, usually the path of its file. Files that
    /// the scene names are looked for in the current folder.
    ///
    /// # Errors
    /// The first rule that is broken, with its place and what would be right.
    pub fn parse(text: &str, name: &str) -> Result<Self, Diagnostic> {
        load::parse(text, name, Path::new(""))
    }

    /// Reads a scene from a file of at most 1 MiB.
    ///
    /// # Errors
    /// As [`Scene::parse`], and a file that cannot be read or is no text.
    pub fn load(path: &Path) -> Result<Self, Diagnostic> {
        load::load(path)
    }

    /// Number of the last tick, N = round(duration · servo_rate), from 0 to 1e9; the run has N + 1 ticks.
    pub fn ticks(&self) -> u64 {
        // The conversion saturates, so that a scene which was never checked cannot panic here.
        (self.duration.get() * self.servo_rate.get()).round() as u64
    }

    /// Servo period T = 1 / servo_rate, in s.
    pub fn period(&self) -> f64 {
        self.servo_rate.get().recip()
    }

    /// Rate at which the environment is evaluated, in Hz, with its default in place.
    pub fn environment_rate(&self) -> f64 {
        self.environment_rate.unwrap_or(self.servo_rate).get()
    }

    /// Servo ticks from one evaluation of the environment to the next, r = servo_rate / environment_rate, at least 1.
    pub fn environment_ratio(&self) -> u64 {
        (self.servo_rate.get() / self.environment_rate()).round() as u64
    }

    /// Dimensions of the space: 1, 2 or 3.
    pub fn dimensions(&self) -> usize {
        self.space.map_or(1, |space| space.dimensions.get().into())
    }

    /// The tick from which on an instant in s has taken effect: ceil(instant servo_rate - 1e-9).
    pub fn tick_of(&self, instant: f64) -> u64 {
        lyapunov::tick_of(instant, self.servo_rate.get())
    }
}
