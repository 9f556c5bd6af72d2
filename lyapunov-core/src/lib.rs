//! The traits of a stabilized sampled loop, and the parts that every stabilizer is made of.
//!
//! A **port** carries an effort (N) and a flow (m/s); power `effort · flow > 0` flows into the environment.
//! A [`Plant`] moves and returns a [`PortSample`]: the motion, and the effort that was really applied. A [`OnePort`]
//! responds with the next effort. Between the two, a [`Stabilizer`] corrects that effort and returns a [`Correction`]:
//! it reads an [`Observer`], which sums the decrease of a [`LyapunovCandidate`] in a [`Ledger`]. An [`Integrator`]
//! solves the [`Dynamics`] of a plant over one period; the dynamics of a mechanical system are [`Mechanics`]. In a loop
//! of your own, [`Readings`] make the samples.
//!
//! Everything is generic over the [`Scalar`] (`f32`, `f64`, [`lanes`] of either, [`DoubleDouble`] for references) and
//! the [`Signal`] (one axis, or an `SVector` of several), needs neither `std` nor an allocator, and does not panic.
//! [`laws`] checks parts of your own, [`telemetry`] keeps what happened.
//!
//! The port of a rigid body carries a [`Screw`], a wrench and a twist, beside the [`Pose`] ([`WithPose`]); a [`TaskPort`]
//! and a [`Jacobian`] join it to the joints of an arm.
//!
//! The traits are written for impedance causality: motion in, effort out. For the dual, effort in and motion out, an
//! [`AdmittanceSample`] takes the place of the `PortSample`, and a flow that of the effort.
//!
//! Not here: scheduling, clocks, threads, names of signals at run time, graphs of blocks. The caller calls.
#![no_std]

#[cfg(feature = "alloc")]
extern crate alloc;

mod accumulator;
mod admittance_sample;
#[cfg(feature = "approx")]
mod approximate;
#[cfg(feature = "alloc")]
mod boxed;
mod candidate;
mod correction;
mod dissipation;
mod double_double;
mod dynamics;
mod effort_range;
mod exact_sum;
mod integrator;
pub mod lanes;
pub mod laws;
mod ledger;
mod lyapunov_function;
mod mechanics;
mod observer;
mod one_port;
mod parameter;
mod plant;
mod port_sample;
mod poses;
mod readings;
mod scalar;
mod signal;
mod signal_axes;
mod snapshot;
mod stabilizer;
mod state;
pub mod telemetry;
mod velocity;

#[cfg(feature = "approx")]
#[doc(hidden)]
pub use approx;

pub use accumulator::{Accumulator, Compensated, Plain, Wide, Widen};
pub use admittance_sample::{AdmittanceSample, HeldFlow};
pub use candidate::{LyapunovCandidate, PortEnergy, StorageFunction};
pub use correction::Correction;
pub use dissipation::{Always, Dissipation, Gate, InContact};
pub use double_double::DoubleDouble;
pub use dynamics::Dynamics;
#[doc(hidden)]
pub use effort_range::EffortRange;
pub use exact_sum::{exact_sum, exact_sums};
pub use integrator::Integrator;
pub use ledger::{Held, Ledger, Sampled, Work};
pub use lyapunov_function::LyapunovFunction;
pub use mechanics::Mechanics;
pub use observer::Observer;
pub use one_port::OnePort;
pub use parameter::{ParameterError, Requirement};
pub use plant::Plant;
pub use port_sample::{HeldTick, PortSample};
pub use poses::{
    Angle, Axes, BodyAxes, Jacobian, Pose, PoseTrack, Screw, Spatial, TaskPort, WithPose, WorldAxes,
};
pub use readings::{
    CheckedSample, Clocked, Measured, MovingReading, PartSpeeds, Poses, Positions, Reading,
    Readings, Steady, Track,
};
pub use scalar::{Mask, Scalar};
pub use signal::Signal;
#[doc(hidden)]
pub use signal_axes::{largest_axis, length_and_direction};
pub use snapshot::Snapshot;
pub use stabilizer::{Stabilized, Stabilizer};
pub use state::State;
#[doc(hidden)]
pub use velocity::careful;
pub use velocity::{Differenced, LowPassed, VelocityEstimator, Windowed};
