//! What the operator holds: bodies that move exactly, and what changes their course.

mod body;
mod impedance;
mod propagation;
mod tethered;

pub use body::Body;
pub use impedance::Impedance;
pub use propagation::held_input;
pub use tethered::Tethered;
