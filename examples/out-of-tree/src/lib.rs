//! A stabilizer and a candidate of one's own, and the loop that runs them: six axes at 1 kHz in `f32`, without `std`.
#![no_std]

mod control;
mod dry_friction;
mod while_giving;

pub use control::{Control, Own, Port, own, shipped};
pub use dry_friction::DryFriction;
pub use while_giving::WhileGiving;
