//! Environments, bodies, exact propagation and the effects that act on a port.
//!
//! Environments answer a motion: [`Spring`] and [`MassSpringDamper`] (the paper's examples 1 and 2), the
//! one-sided [`Wall`] of its evaluation, [`LayeredWall`] and [`HuntCrossley`]; [`MovingWall`] and [`VaryingSpring`],
//! which swing with time; and, on several axes, [`Contact`] with a [`Solid`]. A [`Body`] is what moves, exactly. Effects are adaptors that own the port
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
mod random;

pub use bodies::{Body, Impedance, Tethered, held_input};
pub use effects::{Adapt, AdaptiveWindow, Delay, Difference, Dropout, Encoder, Fallback, Guard, Hold, LowPass, Noise, Saturation};
pub use environments::{Contact, Cuboid, DissipationOf, HuntCrossley, LayeredWall, MassSpringDamper, MovingWall, Nearest, Plane, Solid, Sphere, Spring, VaryingSpring, Wall};
pub use random::{Random, Source};
