#![doc = include_str!("../README.md")]
#![no_std]

pub use lyapunov_core::{
    Accumulator, Action, Always, Beyond, Compensated, Dissipation, Drive, Gate, Held, Ledger,
    LyapunovCandidate, Mask, Observer, OnePort, ParameterError, Plain, Plant, PortEnergy,
    Requirement, Sampled, Scalar, Signal, Stabilized, Stabilizer, Storage, Wide, Widen, Work,
    lanes, laws,
};
pub use lyapunov_plants::{
    Adapt, AdaptiveWindow, Body, Delay, Difference, Dropout, Encoder, Fallback, Guard, Hold,
    Impedance, LowPass, MassSpringDamper, Noise, Random, Saturation, Source, Spring, Tethered,
    Wall, held_input,
};
pub use lyapunov_stabilizers::{DampingLimit, Lolc, Popc};
