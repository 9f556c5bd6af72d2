//! What the operator holds: bodies that move exactly or by steps, and what changes their course.

mod body;
mod friction;
mod grip;
mod impedance;
mod jitter;
mod linear;
mod linked;
mod motion;
mod perturb;
mod propagation;
mod push;
mod stepped;
mod tethered;
mod two_mass;

pub use body::Body;
pub(crate) use body::impedance_increments;
pub use friction::{Friction, Stribeck, Transition, Transitions};
pub use grip::Grip;
pub use impedance::Impedance;
pub use jitter::Jitter;
pub use linear::Linear;
pub use linked::Linked;
pub(crate) use linked::two_mass_increments;
pub use motion::Motion;
pub use perturb::Perturb;
pub use propagation::held_input;
pub use push::Push;
pub use stepped::Stepped;
pub use tethered::Tethered;
pub use two_mass::{DampedMass, Link, TwoMass};
