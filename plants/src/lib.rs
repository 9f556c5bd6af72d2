//! Environments, bodies, exact propagation and the effects that act on a port.
//!
//! Environments answer a motion: [`Spring`], [`MassSpringDamper`] (the paper's examples 1 and 2) and the one-sided
//! [`Wall`] of its evaluation; [`LayeredWall`], [`HuntCrossley`] and [`CubicSpring`]; [`MovingWall`] and [`VaryingSpring`], which swing
//! with time; and, on several axes, [`Contact`] with a [`Solid`]. Each is a [`ForceLaw`]. A [`Body`] is what moves,
//! exactly, and so is [`Linked`], which is two masses; [`Stepped`] moves either by an integrator, such as
//! [`RungeKuttaNystrom4`]. What follows time by itself, a hand or a load, is a [`Course`]. Effects are adaptors that own the
//! port, chained by [`Adapt`], or the body, chained by [`Perturb`], they act on; one that is not written costs nothing.
//! A [`Channel`] carries messages between two loops.
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

mod affine;
#[cfg(feature = "approx")]
mod approximate;
mod bodies;
mod channels;
mod courses;
mod dynamics;
mod effects;
mod environments;
mod integrators;
mod models;
mod random;

pub use affine::{
    AffinePlant, ControlAffine, Decay, Measured, QuadraticForm, StateFeedback, WithFlow, WithState,
    decrease_of,
};
pub use bodies::{
    Body, DampedMass, Friction, Grip, Impedance, Jitter, Linear, Link, Linked, Motion, Perturb,
    Push, Stepped, Stribeck, Tethered, Transition, Transitions, TwoMass, held_input,
};
pub use channels::{Channel, ConstantDelay, Lossy, VaryingDelay};
pub use courses::{Constant, Course, FirstAxis, Pulse, Ramp, Samples, Sine, Step, tick_of};
pub use dynamics::{
    Assembled, Coordinates, CoupledOscillators, ImplicitMechanics, Joined, LinearDynamics,
    Oscillator, Rubbing, RubbingOscillator, Switching, Walled, WalledOscillator,
};
pub use effects::{
    Adapt, AdaptiveWindow, Delay, Difference, Dropout, Encoder, Fallback, Guard, Hold, LowPass,
    Noise, Saturation,
};
pub use environments::{
    Contact, CubicSpring, Cuboid, DissipationOf, ForceLaw, HuntCrossley, Kinematics, LayeredWall,
    MassSpringDamper, MovingWall, Nearest, Plane, Solid, Sphere, Spring, Surface, Time,
    VaryingSpring, Wall,
};
pub use integrators::{
    Adaptive, DormandPrince5, DormandPrince8, EmbeddedPair, Exact, ImplicitMidpoint, Located,
    RungeKutta4, RungeKuttaNystrom4, SemiImplicitEuler,
};
pub use models::{
    AdmittanceDevice, ArmEnergy, DcMotor, Ground, InvertedPendulum, LegEnergy, Limb, MotorEnergy,
    MotorParts, ProstheticLeg, TwoLinkArm, UprightEnergy, VanDerPol,
};
pub use random::{Random, Source};
