//! Solids on ports of several axes, and the contact with them.

mod contact;
mod cuboid;
mod plane;
mod solid;
mod sphere;

pub use contact::Contact;
pub use cuboid::Cuboid;
pub use plane::Plane;
pub use solid::{NearestPoint, Solid};
pub use sphere::Sphere;
