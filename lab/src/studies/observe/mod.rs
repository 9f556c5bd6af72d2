//! Observers over a recorded log of any device.
//!
//! [`observe`] reads a log once, row by row, in memory that does not grow, and reports when energy was generated,
//! how much and by which contact. docs/observe.md defines each number.
//!
//! ```
//! use lyapunov_lab::observe::{Settings, observe};
//!
//! let log = "t,x,f\n0.0,0.000,0\n0.1,0.001,8\n0.2,0.002,16\n0.3,0.001,8\n0.4,0.000,0\n";
//! let observed = observe(log.as_bytes(), "spring.csv", &Settings::default())?;
//! let energy = observed.report.energy;
//! assert!((energy.generated - 0.016).abs() < 1e-12); // a sampled spring of 8 kN/m is not passive
//! println!("{}", observed.report);
//! # Ok::<(), lyapunov_lab::observe::LogError>(())
//! ```

mod candidate;
mod contact;
mod late;
mod marks;
mod observed_energy;
mod page;
mod replay;
mod report;
mod step;
mod tally;
mod text;
mod traces;
mod watch;

pub use crate::files::log::{BadRow, BadRows, Column, Columns, LogError, Role, Scale, opened};
pub use candidate::Candidate;
pub use contact::{Contact, Contacts};
pub use observed_energy::{Debt, ObservedEnergy};
pub use replay::{Asked, Left, NOTE, Replay, Replayed};
pub use report::{ConstantDamper, Energy, Report};
pub use step::{Gap, Gaps};
pub use traces::Traces;

use std::io::Read;

use lyapunov_figures::Figure;

use crate::files::log::Log;
use replay::{Listener, Replays};
use watch::Watch;

/// Settings for reading and observing a log.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Settings {
    /// The columns of time, position, force and velocity.
    pub columns: Columns,
    /// Factors to SI units; those of the same column multiply.
    pub scales: Vec<Scale>,
    /// The candidate whose decrease is summed.
    pub candidate: Candidate,
    /// The force above which there is contact, N; none: 1 % of the largest so far.
    pub contact: Option<f64>,
    /// The rows by which the force acts after its own.
    pub late: u32,
}

impl Settings {
    fn check(&self) -> Result<(), LogError> {
        match self.contact {
            Some(force) if !(force >= 0.0 && force.is_finite()) => {
                Err(LogError::new(format!("the contact threshold is {force} N"))
                    .with_help("give a finite force of 0 N or more"))
            }
            _ => Ok(()),
        }
    }
}

/// Result of observing a log.
#[derive(Clone, Debug)]
pub struct Observed {
    /// The report.
    pub report: Report,
    traces: Traces,
}

impl Observed {
    /// Figure of force, observed energies and position over time.
    pub fn figure(&self) -> Figure {
        self.traces.figure(&self.report)
    }

    /// Figure of the forces that stabilizers would have added; none where nobody would have.
    pub fn would_have(&self) -> Option<Figure> {
        self.report.replay.as_ref()?.figure("force that each stabilizer would have added")
    }
}

/// Reads the log called `name` to its end and observes it.
///
/// # Errors
/// Settings out of range, a log without the requested columns or with fewer than two good rows, or a stream that fails.
pub fn observe(log: impl Read, name: &str, settings: &Settings) -> Result<Observed, LogError> {
    heard(log, name, settings, || Ok(None))
}

/// The same, with what the stabilizers that are asked would have done.
///
/// # Errors
/// As [`observe`], and a scene that does not fit the log or those who are asked.
pub fn replay(
    log: impl Read,
    name: &str,
    settings: &Settings,
    asked: &Asked,
) -> Result<Observed, LogError> {
    heard(log, name, settings, || Ok(Some(Box::new(Replays::of(asked)?))))
}

/// A log that is observed while somebody may listen, who comes once it is open.
fn heard(
    log: impl Read,
    name: &str,
    settings: &Settings,
    listener: impl FnOnce() -> Result<Option<Box<dyn Listener>>, LogError>,
) -> Result<Observed, LogError> {
    settings.check()?;
    let candidate = settings.candidate.checked()?;
    let mut log = Log::open(log, name, &settings.columns, &settings.scales)?;
    let mut watch = Watch::new(candidate, settings, listener()?);
    while let Some(entry) = log.read().map_err(|error| LogError::unreadable(name, &error))? {
        watch.add(&entry);
    }
    let (report, traces) = watch.finish(name)?;
    let report = Report {
        candidate: settings.candidate,
        late: settings.late,
        columns: log.columns().to_vec(),
        decimal_commas: log.has_decimal_commas(),
        notes: log.unread_axes().map(str::to_owned).into_iter().collect(),
        ..report
    };
    Ok(Observed { report, traces })
}
