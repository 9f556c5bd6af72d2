//! Environments, bodies, exact propagation and the effects that act on a port.
//!
//! Environments answer a motion: [`Spring`] and [`MassSpringDamper`] (the paper's examples 1 and 2) and the
//! one-sided [`Wall`] of its evaluation. A [`Body`] is what moves, exactly, and so is [`Linked`], which is two masses.
//! Effects are adaptors that own the port they act on, chained by [`Adapt`], or the body, chained by [`Perturb`];
//! one that is not written costs nothing. What follows time by itself, a hand or a load, is a [`Course`].
//!
//! ```
//! use lyapunov_core::{OnePort, ParameterError, Plant};
//! use lyapunov_plants::{Adapt, Body, Impedance, Wall};
//! let hand = Impedance { mass: 0.3, damping: 0.2, stiffness: 50.0 };
//! let mut plant = Body::new(hand, 1e-3)?.starting(-0.004, 0.0);
//! let mut port = Wall::new(8000.0, 2.0)?.held(10)?.saturated(8.0)?.differenced();
//! let mut drive = plant.start();
//! for _ in 0..1000 {
//!     drive = plant.advance(port.respond(&drive));
//! }
//! # Ok::<(), ParameterError>(())
//! ```
#![no_std]

mod bodies;
mod courses;
mod effects;
mod environments;

pub use bodies::{
    Body, DampedMass, Grip, Impedance, Jitter, Link, Linked, Motion, Perturb, Push, Tethered,
    TwoMass, held_input,
};
pub use courses::{Constant, Course, FirstAxis, Pulse, Ramp, Samples, Sine, Step, tick_of};
pub use effects::{Adapt, Delay, Difference, Encoder, Fallback, Guard, Hold, Saturation};
pub use environments::{MassSpringDamper, Spring, Wall};
