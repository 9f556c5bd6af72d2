//! Telemetry: what happened at a port, kept while the loop runs and read out later.
//!
//! A [`TickRing`] holds the last ticks whole and writes them as comma-separated values that `lyapunov observe` reads. An
//! [`EnergyMeter`] sums the energies of all ticks. Both take what every loop has at hand, the sample and the correction;
//! neither allocates, fails or touches the step.
//!
//! ```
//! use lyapunov_core::telemetry::{EnergyMeter, TickRing};
//! use lyapunov_core::{Correction, PortSample};
//! # use lyapunov_core::HeldTick;
//! let (mut ring, mut meter) = (TickRing::<f64, 256>::new(), EnergyMeter::new());
//! # let stabilize = |_: &PortSample<f64>| Correction::none(2.0);
//! # let moved = HeldTick { period: 1e-3, position: 1e-4, velocity: 0.1, displacement: 1e-4, applied: 2.0 };
//! # for sample in [PortSample::starting(1e-3, 0.0, 0.0), moved.sample()] {
//! let correction = stabilize(&sample); // in a loop of ports: let correction = port.correction();
//! ring.push(&sample, &correction);
//! meter.add(&sample, &correction);
//! # }
//! assert_eq!(meter.summary().absorbed, 2e-4);
//! assert!(ring.csv().to_string().starts_with("t,x,v,f,"));
//! ```

mod csv;
mod energy_meter;
mod tick_ring;

pub use csv::Csv;
pub use energy_meter::{EnergyMeter, EnergySummary};
pub use tick_ring::{RecordedTick, TickRing};
