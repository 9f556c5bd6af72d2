//! Bodies in the operator's hand, moved exactly or by steps, and the adaptors that change their motion.

mod body;
mod external_force;
mod friction;
mod grip;
mod hand_motion;
mod impedance;
mod integrated_plant;
mod jitter;
mod linear;
mod operated_body;
mod plant_ext;
mod propagation;
mod rigid_body;
mod two_mass_body;
mod two_mass_parts;

pub use body::Body;
pub(crate) use body::impedance_increments;
pub use external_force::ExternalForce;
pub use friction::{Friction, IsotropicFriction, Stribeck, Transition, Transitions};
pub use grip::Grip;
pub use hand_motion::HandMotion;
pub use impedance::Impedance;
pub use integrated_plant::IntegratedPlant;
pub use jitter::Jitter;
pub use linear::Linear;
pub use operated_body::OperatedBody;
pub use plant_ext::PlantExt;
pub use propagation::held_input;
pub use rigid_body::{RigidBody, RigidParts};
pub use two_mass_body::TwoMassBody;
pub(crate) use two_mass_body::two_mass_increments;
pub use two_mass_parts::{DampedMass, ElasticJoint, TwoMassParts};
