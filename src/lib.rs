#![doc = include_str!("../README.md")]
#![no_std]

pub use lyapunov_core::{
    Accumulator, Action, Always, Beyond, Compensated, Dissipation, Drive, Gate, Held, Ledger,
    LyapunovCandidate, Mask, Observer, OnePort, ParameterError, Plain, Plant, PortEnergy,
    Requirement, Sampled, Scalar, Signal, Stabilized, Stabilizer, Storage, Wide, Widen, Work,
    lanes, laws,
};
pub use lyapunov_plants::{
    Adapt, Body, Constant, Course, DampedMass, Delay, Difference, Encoder, Fallback, FirstAxis,
    Grip, Guard, Hold, Impedance, Jitter, Link, Linked, MassSpringDamper, Motion, Perturb, Pulse,
    Push, Ramp, Samples, Saturation, Sine, Spring, Step, Tethered, TwoMass, Wall, held_input,
    tick_of,
};
pub use lyapunov_stabilizers::{DampingLimit, Lolc, Popc};
