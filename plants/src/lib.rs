//! Environments, bodies, exact propagation and the effects that act on a port.
#![no_std]

mod adapt;
mod body;
mod delay;
mod difference;
mod encoder;
mod guard;
mod hold;
mod impedance;
mod mass_spring_damper;
mod propagation;
mod saturation;
mod spring;
mod wall;

pub use adapt::Adapt;
pub use body::Body;
pub use delay::Delay;
pub use difference::Difference;
pub use encoder::Encoder;
pub use guard::{Fallback, Guard};
pub use hold::Hold;
pub use impedance::Impedance;
pub use mass_spring_damper::MassSpringDamper;
pub use propagation::held_input;
pub use saturation::Saturation;
pub use spring::Spring;
pub use wall::Wall;
