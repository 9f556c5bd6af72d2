//! Stiffness limits of a scene, by formulas about the linear part of its loop.

mod exact;
mod limits;
mod linear_part;
pub mod llewellyn;
mod loop_map;
mod pair;
mod passivity;
mod polynomial;
mod roots;
mod rules;

pub use limits::Limits;
pub use linear_part::{LinearPart, NotLinear, VelocitySource};
