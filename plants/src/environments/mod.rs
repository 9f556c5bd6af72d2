//! What answers a motion with a force.

mod mass_spring_damper;
mod spring;
mod wall;

pub use mass_spring_damper::MassSpringDamper;
pub use spring::Spring;
pub use wall::Wall;
