//! Laws that every part must keep, with checks to run on parts of your own.
//!
//! The same functions check the parts of this workspace. Each feeds a part [`Samples`] (or any other samples) and
//! returns the first law that is broken as a [`Violation`]: the sample, the force that drove it, the number that broke the
//! law with its unit, what was allowed, and the likely cause. docs/own-stabilizer.md in the repository shows how a part
//! comes to keep them.
//!
//! ```
//! use lyapunov_core::{Correction, PortSample, Stabilizer, laws};
//! /// A damper that always acts.
//! #[derive(Clone)]
//! struct Damper(f64);
//! impl Stabilizer<f64> for Damper {
//!     fn stabilize(&mut self, sample: &PortSample<f64>, effort: f64) -> Correction<f64> {
//!         Correction { alpha: self.0, ..Correction::none(effort + self.0 * sample.velocity) }.checked()
//!     }
//! }
//! laws::stabilizer(&Damper(2.0), laws::Samples::new(1e-3))?;
//! let broken = laws::stabilizer(&Damper(-2.0), laws::Samples::new(1e-3)).unwrap_err();
//! assert_eq!(broken.law, laws::Law::NoNegativeDamping);
//! # Ok::<(), laws::Violation>(())
//! ```

mod adaptor;
mod candidate;
mod decrease;
mod integrator;
mod law;
mod ledger;
mod lyapunov_function;
mod one_port;
mod plant;
mod quantity;
mod samples;
mod snapshot;
mod stabilizer;
mod tick;
mod velocity_estimator;
mod violation;

pub use adaptor::{Probe, adaptor};
pub use candidate::candidate;
pub use decrease::decrease;
pub use integrator::integrator;
pub use law::Law;
pub use ledger::ledger;
pub use lyapunov_function::lyapunov_function;
pub use one_port::one_port;
pub use plant::plant;
pub use quantity::Quantity;
pub use samples::Samples;
pub use snapshot::snapshot;
pub use stabilizer::{limiter, stabilizer};
pub use velocity_estimator::velocity_estimator;
pub use violation::{Allowed, Drive, Violation};

use tick::Tick;
