//! Scene files: the simulated loop, its duration and its stabilizer, as TOML in SI units.
//!
//! [`Scene::load`] reads a file and [`Scene::parse`] a text; both return either a scene that keeps every rule, or one
//! [`Diagnostic`] that names the key, its place, the given value and the remedy.
//!
//! The text is read in two steps. The `toml` crate parses it into a tree with the place of every key; then this
//! module's own deserializer hands that tree to serde. The alternative, `toml::from_str`, reports a fault as a sentence
//! in serde's words, from which key, value and remedy would have to be guessed.
//!
//! The type of a value holds the rule of that value ([`Positive`], [`NonNegative`], [`Finite`], [`Cap`], [`DelayTicks`]
//! and so on). [`Draft::check`], the only way to a [`Scene`], checks the rules between values. To change a scene,
//! change a draft of it: [`Scene::to_draft`].
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
mod draft;
mod effects;
mod environments;
mod explain;
mod fault;
mod integrator;
mod keys;
mod lanes;
mod load;
mod mistaken;
mod motion;
mod node;
mod number;
mod operator;
mod parts;
mod quantity;
mod reader;
mod rules;
mod schema;
mod stabilizers;
mod syntax;
#[cfg(test)]
pub(crate) mod tests;
mod written;

pub(crate) use book::{Book, Key, key};
pub use check::Conflict;
pub(crate) use check::{Refused, check_single, check_ticks, standing_out};
pub use coordinates::Coordinates;
pub(crate) use damping::Damping;
pub use diagnostic::Diagnostic;
pub(crate) use document::read;
pub use draft::Draft;
pub use effects::{
    Delay, Dropout, Effects, Encoder, Filter, Friction, Jitter, Load, Noise, Policy, Pulse,
    Saturation,
};
pub use environments::*;
pub use integrator::Integrator;
pub(crate) use keys::{BOOK, is_number, is_whole, unit};
pub use lanes::Lanes;
pub(crate) use load::{MODEL, TELEOPERATOR, text_of};
pub(crate) use motion::Open;
pub use operator::{Grip, Motion, Operator};
pub use parts::{Device, Initial, Link, Scalar, Space, Velocity};
pub use quantity::{
    Cap, DelayTicks, Dimensions, Finite, HoldTicks, NonNegative, OutOfRange, Positive,
    PositiveLimit, Probability, Seed, Share, StepsPerTick, Ticks, WindowTicks,
};
pub(crate) use quantity::{Quantity, of, two};
pub(crate) use schema::schema_of;
pub use schema::{schema, schema_text};
pub use stabilizers::*;
pub(crate) use written::Keys;

use std::ops::Deref;
use std::sync::Arc;

use serde::Serialize;

/// A checked [`Draft`]: one simulated run that keeps every rule.
///
/// It dereferences to its draft and cannot be changed:
///
/// ```
/// use lyapunov_lab::scene::{Positive, Scene};
///
/// let text = "duration = 1.0\nservo_rate = 1000.0\ndevice.mass = 0.2\nenvironment.spring.stiffness = 100.0\n";
/// let scene = Scene::parse(text, "spring.toml")?;
/// let mut draft = scene.to_draft();
/// draft.servo_rate = Positive::new(500.0)?;
/// let slower = draft.check()?;
/// assert_eq!((scene.ticks(), slower.ticks()), (1000, 500));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// ```compile_fail
/// # use lyapunov_lab::scene::{Positive, Scene};
/// # let text = "duration = 1.0\nservo_rate = 1000.0\ndevice.mass = 0.2\nenvironment.spring.stiffness = 100.0\n";
/// let mut scene = Scene::parse(text, "spring.toml")?;
/// scene.servo_rate = Positive::new(500.0)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(transparent)]
pub struct Scene(Draft);

impl Deref for Scene {
    type Target = Draft;

    fn deref(&self) -> &Draft {
        &self.0
    }
}

impl Scene {
    /// A copy of the draft, to be changed and checked again.
    pub fn to_draft(&self) -> Draft {
        self.0.clone()
    }

    /// The scene of `tree`, which is this one's with numbers replaced; the samples of a motion file stay.
    ///
    /// # Errors
    /// The first fault, in words.
    pub(crate) fn remade(&self, tree: &toml::Value) -> Result<Self, String> {
        let keys: Keys = document::read_made(tree)?;
        let mut draft = Draft::try_from(keys).map_err(|conflict| conflict.to_string())?;
        if let (Some(Motion::File { samples, .. }), Some(Motion::File { samples: own, .. })) =
            (&mut draft.operator.motion, &self.operator.motion)
        {
            *samples = Arc::clone(own);
        }
        draft.check().map_err(|conflict| conflict.to_string())
    }
}
