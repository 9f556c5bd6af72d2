//! Models of plants that are affine in their input, from files, and the stabilizers of their ports side by side.
//!
//! A [`Model`] is a document of its own beside the [`Scene`](crate::Scene): nothing of an operator, a device or an
//! environment applies to it. Both are read in one way, with the same words for what is wrong.

mod building;
mod check;
mod comparison;
mod contestant;
mod controller;
mod document;
mod keys;
mod meter;
mod model;
mod outcome;
mod picture;
mod plant;
mod rig;
mod stabilizer;
mod table;
#[cfg(test)]
mod tests;

pub use comparison::Comparison;
pub use contestant::Contestant;
pub use controller::Controller;
pub use meter::BOUND;
pub use model::{Model, schema_text};
pub use outcome::Score;
pub use plant::{
    DcMotor, Ground, InvertedPendulum, Limb, Plant, ProstheticLeg, TwoLinkArm, VanDerPol,
};
pub use stabilizer::Stabilizer;
