//! Environments, bodies, exact propagation and the effects that act on a port.
//!
//! Environments answer a motion: [`Spring`] and [`MassSpringDamper`] (the paper's examples 1 and 2) and the
//! one-sided [`Wall`] of its evaluation. A [`Body`] is what moves, exactly. Effects are adaptors that own the port
//! they act on, chained by [`Adapt`]; one that is not written costs nothing.
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
mod effects;
mod environments;

pub use bodies::{
    Body, Friction, Impedance, Linear, Stribeck, Tethered, Transition, Transitions, held_input,
};
pub use effects::{Adapt, Delay, Difference, Encoder, Fallback, Guard, Hold, Saturation};
pub use environments::{MassSpringDamper, Spring, Wall};
