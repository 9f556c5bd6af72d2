//! Comparison of models of plants.

mod comparison;
mod document;
mod picture;
mod table;

pub use comparison::Comparison;
