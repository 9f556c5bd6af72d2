#![doc = include_str!("../README.md")]
#![no_std]

pub use lyapunov_core::{
    Accumulator, Action, Always, Beyond, Compensated, Dissipation, Drive, Dynamics, Gate, Held,
    Integrator, Ledger, Load, LyapunovCandidate, Mask, Observer, OnePort, ParameterError, Plain,
    Plant, PortEnergy, Requirement, Sampled, Scalar, Signal, Stabilized, Stabilizer, State,
    Storage, Wide, Widen, Work, lanes, laws,
};
pub use lyapunov_plants::{
    Adapt, AdaptiveWindow, Assembled, Body, Channel, Constant, ConstantDelay, Contact, Coordinates,
    CoupledOscillators, Course, Cuboid, DampedMass, Delay, Difference, DissipationOf, Dropout,
    Encoder, Exact, Fallback, FirstAxis, Friction, Grip, Guard, Hold, HuntCrossley, Impedance,
    ImplicitDynamics, ImplicitMidpoint, Jitter, Joined, LayeredWall, Linear, LinearDynamics, Link,
    Linked, Lossy, LowPass, MassSpringDamper, Motion, MovingWall, Nearest, Noise, Oscillator,
    Perturb, Plane, Pulse, Push, Ramp, Random, RungeKutta4, Samples, Saturation, SemiImplicitEuler,
    Sine, Solid, Source, Sphere, Spring, Step, Stepped, Stribeck, Tethered, Transition,
    Transitions, TwoMass, VaryingDelay, VaryingSpring, Wall, held_input, tick_of,
};
pub use lyapunov_stabilizers::{
    Account, Aimed, Along, Bounded, ContactReset, DampingLimit, DriftCompensated, ForceBound, Lolc,
    Metric, PerAxis, Popc, RateLimit, ReferenceFollowing, Refine, Rise, Spread, Station, Store,
    Tank, Threshold, WaveTransform, Weights, Windowed,
};
