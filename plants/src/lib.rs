//! Environments, bodies, exact propagation and the effects that act on a port.
//!
//! Environments respond to a motion with a force: [`Spring`], [`MassSpringDamper`] (the paper's examples 1 and 2) and
//! the one-sided [`Wall`] of its evaluation; [`LayeredWall`], [`HuntCrossley`] and [`CubicSpring`]; [`MovingWall`] and
//! [`VaryingSpring`], which oscillate in time; and, on several axes, [`Contact`] with a [`Solid`]. Each is a
//! [`ForceLaw`]. On the port of a rigid body [`OrientationSpring`] turns it back, and [`BodyPoints`] puts points of it into any
//! law in space.
//!
//! A [`Body`] is one mass on an operator's hand, a [`TwoMassBody`] two masses; both move exactly. [`IntegratedPlant`]
//! moves either by an integrator, such as [`RungeKuttaNystrom4`]. A [`RigidBody`] tumbles in space, and a [`SerialArm`]
//! has a Jacobian. A [`Trajectory`] gives a hand's motion or a load as a function of time.
//!
//! Effects are adaptors that own the port (chained by [`OnePortExt`]) or the plant (chained by [`PlantExt`]) on which
//! they act; an effect that is absent costs nothing. A [`Channel`] carries messages between two loops.
//!
//! ```
//! use lyapunov_core::{OnePort, ParameterError, Plant};
//! use lyapunov_plants::{OnePortExt, Body, Impedance, Wall};
//! let hand = Impedance { mass: 0.3, damping: 0.2, stiffness: 50.0 };
//! let mut plant = Body::new(hand, 1e-3)?.starting(-0.004, 0.0);
//! let mut port = Wall::new(8000.0, 2.0)?.held(10)?.saturated(8.0)?.differenced();
//! let mut sample = plant.start();
//! for _ in 0..1000 {
//!     sample = plant.advance(port.respond(&sample));
//! }
//! # Ok::<(), ParameterError>(())
//! ```
#![no_std]

mod affine;
#[cfg(feature = "approx")]
mod approximate;
mod bodies;
mod channels;
mod dynamics;
mod effects;
mod elimination;
mod environments;
mod integrators;
mod models;
mod random;
mod trajectories;

pub use affine::{
    AffinePlant, ControlAffine, Decay, MeasuredPlant, QuadraticForm, StateFeedback, WithFlow,
    WithState, decrease_of,
};
pub use bodies::{
    Body, DampedMass, ElasticJoint, ExternalForce, Friction, Grip, HandMotion, Impedance,
    IntegratedPlant, IsotropicFriction, Jitter, Linear, OperatedBody, PlantExt, RigidBody,
    RigidParts, Stribeck, Transition, Transitions, TwoMassBody, TwoMassParts, held_input,
};
pub use channels::{Channel, ConstantDelay, LossyChannel, VaryingDelay};
pub use dynamics::{
    Coordinates, CoupledOscillators, FromParts, ImplicitMechanics, LinearDynamics, Oscillator,
    StickSlipOscillator, StickSlipPhase, Switching, TwoMassCoordinates, WallPhase,
    WalledOscillator,
};
pub use effects::{
    AdaptiveWindow, BackwardDifference, Delay, Dropout, Encoder, Estimated, Fallback, Guard,
    LowPass, Noise, OnePortExt, Saturation, Scaled, ZeroOrderHold,
};
pub use environments::{
    BodyPoints, Contact, CubicSpring, Cuboid, DissipationOf, ForceLaw, HuntCrossley, Kinematics,
    LayeredWall, MassSpringDamper, MovingWall, NearestPoint, OrientationSpring, Plane, Solid,
    Sphere, Spring, Surface, Time, VaryingSpring, Wall,
};
pub use integrators::{
    Adaptive, DormandPrince5, DormandPrince8, EmbeddedPair, EventLocating, Exact, ImplicitMidpoint,
    RungeKutta4, RungeKuttaNystrom4, SemiImplicitEuler,
};
pub use models::{
    AdmittanceDevice, ArmEnergy, ArmLink, ArmPosture, DcMotor, Ground, InvertedPendulum, LegEnergy,
    MotorEnergy, MotorParts, ProstheticLeg, RigidLink, SerialArm, TwoLinkArm, UprightEnergy,
    VanDerPol,
};
pub use random::{Random, Source};
pub use trajectories::{
    Constant, FirstAxis, Pulse, Ramp, RampParts, Samples, Sine, Step, Trajectory, tick_of,
};
