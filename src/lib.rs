#![doc = include_str!("../README.md")]
#![no_std]

pub use lyapunov_core::{
    Accumulator, Action, Always, Beyond, Compensated, Dissipation, Drive, Gate, Held, Ledger,
    LyapunovCandidate, Mask, Observer, OnePort, ParameterError, Plain, Plant, PortEnergy,
    Requirement, Sampled, Scalar, Signal, Stabilized, Stabilizer, Storage, Wide, Widen, Work,
    lanes, laws,
};
pub use lyapunov_plants::{
    Adapt, Body, Delay, Difference, Encoder, Fallback, Friction, Guard, Hold, Impedance, Linear,
    MassSpringDamper, Saturation, Spring, Stribeck, Tethered, Transition, Transitions, Wall,
    held_input,
};
pub use lyapunov_stabilizers::{DampingLimit, Lolc, Popc};
