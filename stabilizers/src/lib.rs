//! The Lyapunov observer/controller, the passivity observer/controller, and their family.
//!
//! [`Lolc`] watches a candidate of your choice; [`Popc`] is the same with the port's own energy. Start with `Popc`, or
//! with a `Lolc` of `(PortEnergy, Dissipation::of(b)?)` where the device surely has a damping of `b`. On several axes
//! both keep one sum; [`PerAxis`] keeps one for each axis, and [`DirectedDamping`] keeps one and dissipates along
//! chosen directions. [`StabilizerExt`] adds to a stabilizer a bound on its credit or a gentler correction.
//!
//! [`ForceBound`], [`SlopeBound`], [`PathMemory`] and [`Tank`] add no damping; they reduce efforts whose energy is not
//! covered. A [`CoupledPort`] couples the device to a port through a spring and a damper. Two [`TwoPortSide`]s stand at
//! the ends of a channel, and a [`WaveTransform`] codes the signals that go through it.
#![no_std]

mod coupled_port;
mod credit;
mod damping_limit;
mod directed_damping;
mod force_bound;
mod lolc;
mod no_stabilizer;
mod path_memory;
mod per_axis;
mod popc;
mod reference_following;
mod shaping;
mod slope_bound;
mod stabilizer_ext;
mod tank;
mod two_port;
mod wave;

pub use coupled_port::{CoupledPort, VirtualCoupling};
pub use credit::{BoundedCredit, ContactReset, LimitCredit, WindowedCredit};
pub use damping_limit::DampingLimit;
pub use directed_damping::{AlongDirection, AxisWeights, DirectedDamping, InertiaMetric, Metric};
pub use force_bound::ForceBound;
pub use lolc::Lolc;
pub use no_stabilizer::NoStabilizer;
pub use path_memory::PathMemory;
pub use per_axis::PerAxis;
pub use popc::Popc;
pub use reference_following::ReferenceFollowing;
pub use shaping::{RateLimit, SoftStart, Spread, VelocityThreshold};
pub use slope_bound::SlopeBound;
pub use stabilizer_ext::StabilizerExt;
pub use tank::{Tank, TankLimits};
pub use two_port::{DriftCompensated, TwoPortSide};
pub use wave::WaveTransform;
