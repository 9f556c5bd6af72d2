#![doc = include_str!("../README.md")]
#![no_std]

pub use lyapunov_core::{
    Accumulator, Action, Always, Beyond, Compensated, Dissipation, DoubleDouble, Drive, Dynamics,
    Gate, Held, Integrator, Ledger, Load, LyapunovCandidate, LyapunovFunction, Mask, Mechanics,
    Observer, OnePort, ParameterError, Plain, Plant, PortEnergy, Requirement, Sampled, Scalar,
    Signal, Stabilized, Stabilizer, State, Storage, Wide, Widen, Work, lanes, laws,
};
pub use lyapunov_plants::{
    Adapt, Adaptive, AdaptiveWindow, AdmittanceDevice, AffinePlant, ArmEnergy, Assembled, Body,
    Channel, Constant, ConstantDelay, Contact, ControlAffine, Coordinates, CoupledOscillators,
    Course, CubicSpring, Cuboid, DampedMass, DcMotor, Decay, Delay, Difference, DissipationOf,
    DormandPrince5, DormandPrince8, Dropout, EmbeddedPair, Encoder, Exact, Fallback, FirstAxis,
    ForceLaw, Friction, Grip, Ground, Guard, Hold, HuntCrossley, Impedance, ImplicitMechanics,
    ImplicitMidpoint, InvertedPendulum, Jitter, Joined, Kinematics, LayeredWall, LegEnergy, Limb,
    Linear, LinearDynamics, Link, Linked, Located, Lossy, LowPass, MassSpringDamper, Measured,
    Motion, MotorEnergy, MotorParts, MovingWall, Nearest, Noise, Oscillator, Perturb, Plane,
    ProstheticLeg, Pulse, Push, QuadraticForm, Ramp, Random, Rubbing, RubbingOscillator,
    RungeKutta4, RungeKuttaNystrom4, Samples, Saturation, SemiImplicitEuler, Sine, Solid, Source,
    Sphere, Spring, StateFeedback, Step, Stepped, Stribeck, Surface, Switching, Tethered, Time,
    Transition, Transitions, TwoLinkArm, TwoMass, UprightEnergy, VanDerPol, VaryingDelay,
    VaryingSpring, Wall, Walled, WalledOscillator, WithFlow, WithState, decrease_of, held_input,
    tick_of,
};
pub use lyapunov_stabilizers::{
    Account, Aimed, Along, Bounded, ContactReset, Coupled, Coupling, DampingLimit,
    DriftCompensated, ForceBound, Inertia, Lolc, Metric, NoStabilizer, PathMemory, PerAxis, Popc,
    RateLimit, ReferenceFollowing, Refine, Rise, SlopeBound, Spread, Station, Store, Tank,
    Threshold, WaveTransform, Weights, Windowed,
};
