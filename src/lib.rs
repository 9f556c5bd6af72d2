#![doc = include_str!("../README.md")]
#![no_std]

pub use lyapunov_core::{
    Accumulator, Action, Always, Beyond, Compensated, Dissipation, Drive, Gate, Held, Ledger,
    LyapunovCandidate, Mask, Observer, OnePort, ParameterError, Plain, Plant, PortEnergy,
    Requirement, Sampled, Scalar, Signal, Stabilized, Stabilizer, Storage, Wide, Widen, Work,
    lanes, laws,
};
pub use lyapunov_plants::{
    Adapt, AdaptiveWindow, Body, Constant, Contact, Course, Cuboid, DampedMass, Delay, Difference,
    DissipationOf, Dropout, Encoder, Fallback, FirstAxis, Friction, Grip, Guard, Hold,
    HuntCrossley, Impedance, Jitter, LayeredWall, Linear, Link, Linked, LowPass, MassSpringDamper,
    Motion, MovingWall, Nearest, Noise, Perturb, Plane, Pulse, Push, Ramp, Random, Samples,
    Saturation, Sine, Solid, Source, Sphere, Spring, Step, Stribeck, Tethered, Transition,
    Transitions, TwoMass, VaryingSpring, Wall, held_input, tick_of,
};
pub use lyapunov_stabilizers::{DampingLimit, Lolc, Popc};
