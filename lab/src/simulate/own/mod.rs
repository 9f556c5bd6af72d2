//! Stabilizers and candidates of your own among those that ship: by name in scenes, in every command and study.
//!
//! [`OwnStabilizer`] and [`OwnCandidate`] say what the lab has to know of one; a [`Roster`] enters them, once and before any
//! name or scene is read. From then on they are a [`StabilizerName`](crate::family::StabilizerName) and a table of scenes.
//!
//! ```
//! use lyapunov::{ParameterError, Popc, PortEnergy, Signal, Stabilizer};
//! use lyapunov_lab::compare::{Comparison, Entrants};
//! use lyapunov_lab::own::{Loop, OwnNumber, OwnStabilizer, Promise, Roster};
//! use lyapunov_lab::paper;
//!
//! /// POPC under a name of its own.
//! struct MyPopc;
//!
//! impl OwnStabilizer for MyPopc {
//!     const NAME: &'static str = "my-popc";
//!     const NUMBERS: &'static [OwnNumber] = &[OwnNumber::DAMPING_CAP];
//!     const PROMISE: Promise = Promise::Serves;
//!
//!     fn make<V: Signal>(on: &Loop<'_>) -> Result<impl Stabilizer<V> + 'static, ParameterError> {
//!         Ok(Popc::new(PortEnergy, on.damping_limit::<V::Scalar>()?))
//!     }
//! }
//!
//! Roster::new().stabilizer::<MyPopc>().enter()?;
//! let entrants = Entrants::<f64>::of(["popc".parse()?, "my-popc".parse()?]);
//! let comparison = Comparison::of("8 kN/m", &paper::Case::Plain8k.scene()?, &entrants)?;
//! let [popc, mine] = [0, 1].map(|row| comparison.scores().nth(row).unwrap().settling_time);
//! assert_eq!(popc, mine);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod maker;
mod own_candidate;
mod own_stabilizer;
mod roster;

pub use own_candidate::OwnCandidate;
pub use own_stabilizer::OwnStabilizer;
pub use roster::Roster;
