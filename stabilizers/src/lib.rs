//! The Lyapunov observer/controller and the passivity observer/controller.
//!
//! [`Lolc`] watches a candidate of one's choice, [`Popc`] is the same with the port's own energy. Start with
//! `Popc`, or with `(PortEnergy, Dissipation::of(b)?)` where the device surely has a damping of `b`. On several axes both keep one sum;
//! [`PerAxis`] keeps one for each.
#![no_std]

mod damping_limit;
mod lolc;
mod per_axis;
mod popc;

pub use damping_limit::DampingLimit;
pub use lolc::Lolc;
pub use per_axis::PerAxis;
pub use popc::Popc;
