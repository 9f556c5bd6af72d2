//! What the operator holds: bodies that move exactly, and what changes their course.

mod body;
mod friction;
mod impedance;
mod linear;
mod propagation;
mod tethered;

pub use body::Body;
pub use friction::{Friction, Stribeck, Transition, Transitions};
pub use impedance::Impedance;
pub use linear::Linear;
pub use propagation::held_input;
pub use tethered::Tethered;
