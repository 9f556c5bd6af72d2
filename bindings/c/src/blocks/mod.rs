//! Blocks of C, an entry for each.

mod controllers;

pub use controllers::*;

/// Describes all blocks.
#[cfg(feature = "describe")]
pub fn describe(header: &mut crate::describe::Header) {
    controllers::describe(header);
}
