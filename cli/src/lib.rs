//! The command line of lyapunov, for stabilizers and candidates of your own among those that ship.
//!
//! A program of a few lines has every command of the binary `lyapunov`, and its own stabilizers in each of them by name:
//!
//! ```no_run
//! use std::process::ExitCode;
//!
//! use lyapunov::{ParameterError, Popc, PortEnergy, Signal, Stabilizer};
//! use lyapunov_cli::Bench;
//! use lyapunov_lab::own::{Loop, OwnNumber, OwnStabilizer, Promise};
//!
//! struct Mine;
//!
//! impl OwnStabilizer for Mine {
//!     const NAME: &'static str = "mine";
//!     const NUMBERS: &'static [OwnNumber] = &[OwnNumber::DAMPING_CAP];
//!     const PROMISE: Promise = Promise::Serves;
//!
//!     fn make<V: Signal>(on: &Loop<'_>) -> Result<impl Stabilizer<V> + 'static, ParameterError> {
//!         Ok(Popc::new(PortEnergy, on.damping_limit::<V::Scalar>()?))
//!     }
//! }
//!
//! fn main() -> ExitCode {
//!     Bench::new().stabilizer::<Mine>().main()
//! }
//! ```
//!
//! `program compare scene.toml --stabilizers mine,popc`, and `map`, `tune` and `hard` likewise; a scene names it by a table
//! `[stabilizer.mine]`.

mod bench;
mod commands;
mod files;
mod interrupts;
#[cfg(feature = "parquet")]
mod parquet;
mod pictures;

pub use bench::Bench;
pub use interrupts::interrupt;
