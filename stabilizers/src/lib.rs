//! The Lyapunov observer/controller, the passivity observer/controller, and their family.
//!
//! [`Lolc`] watches a candidate of your choice; [`Popc`] is the same with the port's own energy. Start with `Popc`, or
//! with a `Lolc` of `(PortEnergy, Dissipation::of(b)?)` where the device surely has a damping of `b`. On several axes
//! both keep one sum; [`PerAxis`] keeps one for each axis, and [`DirectedDamping`] keeps one and dissipates along
//! chosen directions. [`StabilizerExt`] adds to a stabilizer a bound on its credit, a gentler correction, limits of what a sample
//! can be, or a [`Watchdog`]. [`LeastNorm`] looks one period ahead. On the port of a rigid body [`PerPart`] keeps translation and
//! rotation apart, [`PartLimits`] limits both under one sum, and [`InertiaLimit`] takes the limit from an arm's inertia at
//! every tick. A [`Member`] of the family is chosen at run time.
//!
//! [`EnergyBounding`], [`ForceBounding`], [`SlopeBound`], [`MemoryBased`], [`PathMemory`] and [`Tank`] add no damping;
//! they reduce efforts whose energy is not covered. Around an environment stand [`CoupledPort`], a spring and a damper,
//! and [`InputToState`], which asks it a little before the device is there. At the ends of a channel stand two
//! [`TwoPortSide`]s, two [`TwoLayer`]s, or a [`WaveTransform`] that codes the signals that go through it.
#![no_std]

#[cfg(feature = "alloc")]
extern crate alloc;

mod account;
mod coupled_port;
mod credit;
mod damping_limit;
mod directed_damping;
mod energy_bounding;
mod factors;
mod force_bounding;
mod hypotenuse;
mod inertia;
mod input_to_state;
mod least_norm;
mod limiting;
mod lolc;
mod member;
mod memory_based;
mod no_stabilizer;
mod parts;
mod path_memory;
mod per_axis;
mod plausible;
mod popc;
mod range;
mod reference_following;
mod shaping;
mod slope_bound;
mod stabilizer_ext;
mod tank;
mod two_layer;
mod two_port;
mod watchdog;
mod wave;

pub use account::Account;
pub use coupled_port::{CoupledPort, VirtualCoupling};
pub use credit::{BoundedCredit, ContactReset, LimitCredit, WindowedCredit};
pub use damping_limit::DampingLimit;
pub use directed_damping::{AlongDirection, AxisWeights, DirectedDamping, InertiaMetric, Metric};
pub use energy_bounding::{EnergyBounding, PublishedBand, TightBand};
pub use force_bounding::{
    DampingMatrix, DeviceDamping, EveryAxis, ForceBound, ForceBounding, FreshContact, KeptCredit,
};
pub use inertia::{Inertia, JointInertia, TaskInertia};
pub use input_to_state::InputToState;
pub use least_norm::{Constraint, Input, LeastNorm};
pub use lolc::Lolc;
pub use member::{Member, MemberState};
pub use memory_based::MemoryBased;
pub use no_stabilizer::NoStabilizer;
pub use parts::{BodyInertia, PartLimits, PerPart};
pub use path_memory::PathMemory;
pub use per_axis::PerAxis;
pub use plausible::{Plausibility, Plausible};
pub use popc::Popc;
pub use reference_following::{ReferenceDamper, ReferenceFollowing};
pub use shaping::{InertiaLimit, RateLimit, SoftStart, Spread, VelocityThreshold};
pub use slope_bound::SlopeBound;
pub use stabilizer_ext::StabilizerExt;
pub use tank::{BoundedValve, EnergyTank, OpenValve, Tank, TankLimits, Valve};
pub use two_layer::{Sharing, TwoLayer};
pub use two_port::{DriftCompensated, TwoPortSide};
pub use watchdog::{Watchdog, WatchdogTimes};
pub use wave::{Following, WaveFilter, WaveFollower, WaveTransform};
