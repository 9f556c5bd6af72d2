//! The Lyapunov observer/controller and the passivity observer/controller.
//!
//! [`Lolc`] watches a candidate of one's choice, [`Popc`] is the same with the port's own energy. Start with
//! `Popc`, or with `(PortEnergy, Dissipation::of(b)?)` where the device surely has a damping of `b`.
#![no_std]

mod damping_limit;
mod lolc;
mod popc;

pub use damping_limit::DampingLimit;
pub use lolc::Lolc;
pub use popc::Popc;
