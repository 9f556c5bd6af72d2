//! Models of control-affine plants from files: their results, and the files that are refused.

mod bad;
mod examples;
mod hand;
pub(crate) mod shipped;
