#![doc = include_str!("../README.md")]
#![no_std]

pub use lyapunov_core::{
    Accumulator, Action, Always, Beyond, Compensated, Dissipation, Drive, Gate, Held, Ledger,
    LyapunovCandidate, Mask, Observer, OnePort, ParameterError, Plain, Plant, PortEnergy,
    Requirement, Sampled, Scalar, Signal, Stabilized, Stabilizer, Storage, Wide, Widen, Work,
    lanes, laws,
};
pub use lyapunov_plants::{
    Adapt, AdaptiveWindow, Body, Contact, Cuboid, Delay, Difference, DissipationOf, Dropout, Encoder, Fallback, Guard, Hold, HuntCrossley, Impedance, LayeredWall, LowPass, MassSpringDamper, MovingWall, Nearest, Noise, Plane, Random, Saturation, Solid, Source, Sphere, Spring, Tethered, VaryingSpring, Wall, held_input,
};
pub use lyapunov_stabilizers::{DampingLimit, Lolc, Popc};
