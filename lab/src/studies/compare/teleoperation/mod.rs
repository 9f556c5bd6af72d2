//! Comparison of teleoperators.

mod comparison;
mod document;
mod picture;
mod table;

pub use comparison::Comparison;
