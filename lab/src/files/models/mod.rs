//! Model files: control-affine plants.
//!
//! A [`Model`] is a separate kind of file from a [`Scene`](crate::Scene): it has no operator, no device and no
//! environment. The same reader reads both, with the same messages.

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
