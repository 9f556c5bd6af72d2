//! The Lyapunov observer/controller and the passivity observer/controller.
#![no_std]

mod damping_limit;
mod lolc;
mod popc;

pub use damping_limit::DampingLimit;
pub use lolc::Lolc;
pub use popc::Popc;
