//! Blocks of C, an entry for each.

mod bounding;
mod controllers;
mod custom;
mod reading;
mod refined;
mod two_port;
mod watching;
mod wave;

pub use bounding::*;
pub use controllers::*;
pub use custom::*;
pub use reading::*;
pub use refined::*;
pub use two_port::*;
pub use watching::*;
pub use wave::*;

/// Describes all blocks.
#[cfg(feature = "describe")]
pub fn describe(header: &mut crate::describe::Header) {
    reading::describe(header);
    controllers::describe(header);
    custom::describe(header);
    refined::describe(header);
    bounding::describe(header);
    two_port::describe(header);
    wave::describe(header);
    watching::describe(header);
}
