//! The Lyapunov observer/controller, the passivity observer/controller, and their family.
//!
//! [`Lolc`] watches a candidate of one's choice, [`Popc`] is the same with the port's own energy. Start with
//! `Popc`, or with `(PortEnergy, Dissipation::of(b)?)` where the device surely has a damping of `b`. On several axes both keep one sum;
//! [`PerAxis`] keeps one for each, [`Aimed`] keeps one and burns along chosen directions. [`Refine`] adds to a stabilizer
//! what it does not have: a bound on its credit, a gentler correction. [`ForceBound`], [`SlopeBound`], [`PathMemory`] and [`Tank`]
//! add no damping; they make efforts smaller that cannot be paid for. A [`Coupled`] port is felt through a spring and a damper.
//! Two [`Station`]s stand at the ends of a channel, and a [`WaveTransform`] codes what goes through it.
#![no_std]

mod account;
mod aimed;
mod coupling;
mod damping_limit;
mod force_bound;
mod lolc;
mod no_stabilizer;
mod path_memory;
mod per_axis;
mod popc;
mod reference_following;
mod refine;
mod shaping;
mod slope_bound;
mod tank;
mod two_port;
mod wave;

pub use account::{Account, Bounded, ContactReset, Windowed};
pub use aimed::{Aimed, Along, Inertia, Metric, Weights};
pub use coupling::{Coupled, Coupling};
pub use damping_limit::DampingLimit;
pub use force_bound::ForceBound;
pub use lolc::Lolc;
pub use no_stabilizer::NoStabilizer;
pub use path_memory::PathMemory;
pub use per_axis::PerAxis;
pub use popc::Popc;
pub use reference_following::ReferenceFollowing;
pub use refine::Refine;
pub use shaping::{RateLimit, Rise, Spread, Threshold};
pub use slope_bound::SlopeBound;
pub use tank::{Store, Tank};
pub use two_port::{DriftCompensated, Station};
pub use wave::WaveTransform;
