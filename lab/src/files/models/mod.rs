//! Files of models of plants that are affine in their input.
//!
//! A [`Model`] is a document of its own beside the [`Scene`](crate::Scene): nothing of an operator, a device or an
//! environment applies to it. Both are read in one way, with the same words for what is wrong.

mod check;
mod keys;
mod model;
pub(crate) mod plant;
#[cfg(test)]
mod tests;

pub(crate) use keys::BOOK;
pub use model::{Controller, Model, Stabilizer, schema_text};
pub use plant::{
    DcMotor, Ground, InvertedPendulum, Limb, Plant, ProstheticLeg, TwoLinkArm, VanDerPol,
};
