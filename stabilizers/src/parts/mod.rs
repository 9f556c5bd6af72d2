//! Translation and rotation of a rigid body, treated apart.

mod part_limits;
mod per_part;

pub use part_limits::{BodyInertia, PartLimits};
pub use per_part::PerPart;
