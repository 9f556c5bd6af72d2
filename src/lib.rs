//! Stabilizers for sampled control loops.
//!
//! A virtual wall that is too stiff for its sampling rate, or a force that acts late, feeds energy into a loop until it
//! buzzes or runs away. A stabilizer sums the energy that crosses the port and adds just enough damping to take back
//! what came out beyond what went in. No model of what is behind the port is needed; nothing here allocates, panics or needs
//! `std`.
//!
//! ```
//! use lyapunov::{DampingLimit, ParameterError, Popc, PortEnergy, Reading, Readings, Stabilizer};
//!
//! fn control(
//!     mut read: impl FnMut() -> f64,
//!     mut motor: impl FnMut(f64) -> f64,
//! ) -> Result<(), ParameterError> {
//!     let period = 1e-3; // s
//!     let limit = DampingLimit::of_mass(0.5, 0.2, period)?; // 0.2 kg: the least that moves
//!     let mut popc = Popc::new(PortEnergy, limit);
//!     let mut readings = Readings::every(period)?.no_faster_than(2.0)?; // m/s: no hand moves faster
//!     let mut applied = 0.0;
//!     for _ in 0..1000 {
//!         let sample = readings.read(Reading { position: read(), applied }).sample;
//!         let wall = if sample.position > 0.0 { 8000.0 * sample.position } else { 0.0 };
//!         let correction = popc.stabilize(&sample, wall);
//!         applied = motor(correction.effort); // pushes with −effort, returns the effort it applied
//!     }
//!     Ok(())
//! }
//! # let _ = control(|| 0.001, |effort| effort);
//! ```
//!
//! The root holds what every loop needs: a [`PortSample`] comes in, and a [`Stabilizer`] ([`Popc`], or [`Lolc`] with a
//! [`LyapunovCandidate`] of your own) returns a [`Correction`]. In simulation a [`Plant`] moves and a [`OnePort`]
//! responds. Everything is generic over a [`Scalar`] (`f32`, `f64`, [`lanes`] of either) and a [`Signal`] (one axis, or
//! an `SVector` of several); [`prelude`] brings the traits whose methods a loop calls.
//!
//! | module | holds |
//! |---|---|
//! | [`stabilizers`] | the family of POPC and LOLC: bounded credit, gentler corrections, tanks, two-port sides, waves |
//! | [`candidates`] | terms of a Lyapunov candidate, and the gates that open them |
//! | [`readings`] | the memory of a port in a loop of your own: first tick, gaps, clock, velocity filters |
//! | [`environments`] | virtual walls, springs and solids |
//! | [`bodies`] | masses on an operator's hand, with friction, elastic joints, a changing grip |
//! | [`effects`] | encoder, noise, filters, hold, delay, dropout, saturation, guard |
//! | [`trajectories`] | functions of time that a hand or a load follows |
//! | [`channels`] | constant, varying and lossy channels of a teleoperator |
//! | [`integrators`] | equations of motion, and methods that follow them |
//! | [`poses`] | the port of a rigid body: poses, twists, wrenches, Jacobians |
//! | [`models`] | control-affine plants with their Lyapunov functions |
//! | [`accumulators`] | plain, compensated and wide sums |
//! | [`lanes`] | SIMD: one number that holds those of several independent runs |
//! | [`laws`] | checks to run on parts of your own |
//! | [`telemetry`] | the last ticks in a ring, and the energies of all of them |
//!
//! What is chosen at run time is a [`Member`](stabilizers::Member) of the family; with the feature `alloc` a
//! `Box<dyn Stabilizer<V>>` is a stabilizer too. A stabilizer or candidate of your own: docs/own-stabilizer.md in the
//! repository goes through it from the first `if` to the last law.
//!
//! | feature | adds |
//! |---|---|
//! | `alloc` | a box of a stabilizer, candidate, port or plant is one itself |
//! | `approx` | comparison within a tolerance for samples, corrections and other values |
//! | `defmt` | `Format` for the same, to log them over a debug probe |
//! | `serde` | `Serialize` and `Deserialize` for the same |
//!
//! A feature that is off adds nothing; none of them changes a step.
#![no_std]

pub use lyapunov_core::{
    AdmittanceSample, CheckedSample, Correction, Dissipation, Held, HeldFlow, HeldTick, Ledger,
    LyapunovCandidate, Mask, MovingReading, Observer, OnePort, ParameterError, Plant, PortEnergy,
    PortSample, Reading, Readings, Requirement, Sampled, Scalar, Signal, Snapshot, Stabilized,
    Stabilizer, StorageFunction, Work, lanes, laws, telemetry,
};
pub use lyapunov_stabilizers::{DampingLimit, Lolc, Popc};

#[doc(hidden)]
pub use lyapunov_core::{careful, one_axis};

/// Prelude: the traits whose methods a control loop calls, and the types it starts with; `use lyapunov::prelude::*`.
pub mod prelude {
    pub use crate::bodies::PlantExt;
    pub use crate::effects::OnePortExt;
    pub use crate::stabilizers::{Account, StabilizerExt};
    pub use crate::{
        DampingLimit, HeldTick, LyapunovCandidate, OnePort, Plant, PortEnergy, PortSample, Reading,
        Readings, Scalar, Signal, Snapshot, Stabilizer,
    };
}

/// Accumulators: running sums of energy.
pub mod accumulators {
    pub use lyapunov_core::{Accumulator, Compensated, DoubleDouble, Plain, Wide, Widen};
}

/// Terms of a Lyapunov candidate beyond those of the root, and the gates that open them.
pub mod candidates {
    pub use lyapunov_core::{Always, Gate, InContact, LyapunovFunction};
}

/// Velocities of [`Readings`], and their time.
pub mod readings {
    pub use lyapunov_core::{
        CheckedSample, Clocked, Differenced, LowPassed, Measured, MovingReading, PartSpeeds, Poses,
        Positions, Reading, Readings, Steady, Track, VelocityEstimator, Windowed,
    };
}

/// Virtual environments, which respond to a motion with a force.
pub mod environments {
    pub use lyapunov_plants::{
        BodyPoints, Contact, CubicSpring, Cuboid, DissipationOf, ForceLaw, HuntCrossley,
        Kinematics, LayeredWall, MassSpringDamper, MovingWall, NearestPoint, OrientationSpring,
        Plane, Solid, Sphere, Spring, Surface, Time, VaryingSpring, Wall,
    };
}

/// Bodies that move under the effort at their port, and the other forces on them.
pub mod bodies {
    pub use lyapunov_plants::{
        Body, DampedMass, ElasticJoint, ExternalForce, Friction, FromParts, Grip, HandMotion,
        Impedance, IntegratedPlant, IsotropicFriction, Jitter, Linear, OperatedBody, PlantExt,
        RigidBody, RigidParts, Stribeck, Transition, Transitions, TwoMassBody, TwoMassParts,
        held_input,
    };
}

/// Imperfections of the sampled loop, as adaptors of a port.
pub mod effects {
    pub use lyapunov_plants::{
        AdaptiveWindow, BackwardDifference, Delay, Dropout, Encoder, Estimated, Fallback, Guard,
        LowPass, Noise, OnePortExt, Random, Saturation, Scaled, Source, ZeroOrderHold,
    };
}

/// Functions of time that a hand or a load follows.
pub mod trajectories {
    pub use lyapunov_plants::{
        Constant, FirstAxis, Pulse, Ramp, RampParts, Samples, Sine, Step, Trajectory, tick_of,
    };
}

/// Channels that carry messages between the two sides of a teleoperator.
pub mod channels {
    pub use lyapunov_plants::{Channel, ConstantDelay, LossyChannel, VaryingDelay};
}

/// Equations of motion, and the methods that solve them in time.
pub mod integrators {
    pub use lyapunov_core::{Dynamics, Integrator, Mechanics, State};
    pub use lyapunov_plants::{
        Adaptive, Coordinates, CoupledOscillators, DormandPrince5, DormandPrince8, EmbeddedPair,
        EventLocating, Exact, ImplicitMechanics, ImplicitMidpoint, LinearDynamics, Oscillator,
        RungeKutta4, RungeKuttaNystrom4, SemiImplicitEuler, StickSlipOscillator, StickSlipPhase,
        Switching, TwoMassCoordinates, WallPhase, WalledOscillator,
    };
}

/// Control-affine plants, and the Lyapunov functions that make a port of their input.
pub mod models {
    pub use lyapunov_core::LyapunovFunction;
    pub use lyapunov_plants::{
        AdmittanceDevice, AffinePlant, ArmEnergy, ArmLink, ArmPosture, ControlAffine, DcMotor,
        Decay, Ground, InvertedPendulum, LegEnergy, MeasuredPlant, MotorEnergy, MotorParts,
        ProstheticLeg, QuadraticForm, RigidLink, SerialArm, StateFeedback, TwoLinkArm,
        UprightEnergy, VanDerPol, WithFlow, WithState, decrease_of,
    };
}

/// Poses, twists and wrenches: the port of a rigid body, and of an arm through its Jacobian.
pub mod poses {
    pub use lyapunov_core::{
        Angle, Axes, BodyAxes, Jacobian, Pose, PoseTrack, Screw, Spatial, TaskPort, WithPose,
        WorldAxes,
    };
}

/// Family around [`Lolc`] and [`Popc`]: adaptors that refine them, and other stabilizers.
pub mod stabilizers {
    pub use lyapunov_stabilizers::{
        Account, AlongDirection, AxisWeights, BodyInertia, BoundedCredit, BoundedValve, Constraint,
        ContactReset, CoupledPort, DampingMatrix, DeviceDamping, DirectedDamping, DriftCompensated,
        EnergyBounding, EnergyTank, EveryAxis, Following, ForceBound, ForceBounding, FreshContact,
        Inertia, InertiaLimit, InertiaMetric, Input, InputToState, JointInertia, KeptCredit,
        LeastNorm, LimitCredit, Member, MemberState, MemoryBased, Metric, NoStabilizer, OpenValve,
        PartLimits, PathMemory, PerAxis, PerPart, Plausibility, Plausible, PublishedBand,
        RateLimit, ReferenceDamper, ReferenceFollowing, Sharing, SlopeBound, SoftStart, Spread,
        StabilizerExt, Tank, TankLimits, TaskInertia, TightBand, TwoLayer, TwoPortSide, Valve,
        VelocityThreshold, VirtualCoupling, Watchdog, WatchdogTimes, WaveFilter, WaveFollower,
        WaveTransform, WindowedCredit,
    };
}

/// The README's examples, tested with the others.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

/// The page about a stabilizer of one's own, tested with the others.
#[cfg(doctest)]
#[doc = include_str!("../docs/own-stabilizer.md")]
struct OwnStabilizer;

/// The page about what may be changed and stored between ticks, tested with the others.
#[cfg(doctest)]
#[doc = include_str!("../docs/retuning.md")]
struct Retuning;

/// The page about telemetry and choice at run time, tested with the others.
#[cfg(doctest)]
#[doc = include_str!("../docs/telemetry.md")]
struct Telemetry;
