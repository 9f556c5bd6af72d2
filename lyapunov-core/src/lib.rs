//! Scalars, ports, Lyapunov candidates, ledgers and the traits of a stabilized loop.
#![no_std]

mod accumulator;
mod action;
mod candidate;
mod dissipation;
mod drive;
pub mod lanes;
pub mod laws;
mod ledger;
mod observer;
mod one_port;
mod parameter;
mod plant;
mod scalar;
mod signal;
mod stabilizer;

pub use accumulator::{Accumulator, Compensated, Plain, Wide, Widen};
pub use action::Action;
pub use candidate::{LyapunovCandidate, PortEnergy, Storage};
pub use dissipation::{Always, Beyond, Dissipation, Gate};
pub use drive::Drive;
pub use ledger::{Held, Ledger, Sampled, Work};
pub use observer::Observer;
pub use one_port::OnePort;
pub use parameter::{ParameterError, Requirement};
pub use plant::Plant;
pub use scalar::{Mask, Scalar};
pub use signal::Signal;
pub use stabilizer::{Stabilized, Stabilizer};
