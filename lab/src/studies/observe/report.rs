//! Report on a log.

use serde::Serialize;

use super::candidate::Candidate;
use super::contact::Contacts;
use super::observed_energy::ObservedEnergy;
use super::replay::Replay;
use super::step::Gaps;
use crate::files::log::{BadRows, Column};
use crate::measure::Oddity;
use crate::show::json;

/// Report on a log, in SI units; `Display` formats it for the terminal.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Report {
    /// The name of the log.
    pub log: String,
    /// The columns as they were read.
    pub columns: Vec<Column>,
    /// Whether the numbers have decimal commas.
    pub decimal_commas: bool,
    /// The candidate whose decrease is summed.
    pub candidate: Candidate,
    /// The rows by which the force acts after its own, as told; left out of the JSON where it does not.
    #[serde(skip_serializing_if = "is_zero")]
    pub late: u32,
    /// The number of good rows.
    pub rows: u64,
    /// The bad rows.
    pub bad_rows: BadRows,
    /// Time of the first good row, s.
    pub start: f64,
    /// Time of the last good row, s.
    pub end: f64,
    /// Time between the two, s.
    pub duration: f64,
    /// Median of the first 1024 time steps, s.
    pub median_period: f64,
    /// The gaps: time steps that are too long.
    pub gaps: Gaps,
    /// Whether the log starts in contact; energy stored before may then come out later.
    pub starts_in_contact: bool,
    /// Whether the log ends in contact; energy stored by then may still come out.
    pub ends_in_contact: bool,
    /// Energy over the port.
    pub energy: Energy,
    /// The observed energy by held work.
    pub observed_energy: ObservedEnergy,
    /// The constant damper that the debts ask for over the recorded motion.
    pub damper: ConstantDamper,
    /// The observed energy by sampled work, as the paper prints it.
    pub printed: ObservedEnergy,
    /// The contacts.
    pub contacts: Contacts,
    /// The signs of a mistake in the log, such as a unit that looks off.
    pub look_at: Vec<Oddity>,
    /// Sentences about the rest of the log; left out of the JSON where there is nothing.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
    /// What stabilizers would have done; none where nobody was asked.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub replay: Option<Replay>,
}

fn is_zero(rows: &u32) -> bool {
    *rows == 0
}

impl Report {
    /// The report as JSON; docs/observe.md lists its keys.
    pub fn to_json(&self) -> String {
        json::text(self)
    }
}

/// Energy over the port, by held work.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Energy {
    /// Sum of the positive works, J.
    pub absorbed: f64,
    /// Sum of the negative works without their sign, J.
    pub released: f64,
    /// `released − absorbed`, J: above 0 if the port generated energy.
    pub generated: f64,
    /// The candidate's credit, J.
    pub credited: f64,
}

/// The smallest constant damper that dissipates, over the recorded motion from the first row on, every debt by the time it
/// arises: the largest of `−L(n) / Σ v² T` up to row `n`. With a damper the motion would have been another, so this says
/// nothing about a damped loop.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ConstantDamper {
    /// The damping, N·s/m; none if a debt came before any motion.
    pub damping: Option<f64>,
    /// Time of the row that needs it, s; none if there was no debt.
    pub at: Option<f64>,
}

impl Default for ConstantDamper {
    fn default() -> Self {
        Self { damping: Some(0.0), at: None }
    }
}

impl ConstantDamper {
    pub(super) fn add(&mut self, time: f64, needed: Option<f64>) {
        let Some(known) = self.damping else { return };
        if needed.is_none_or(|needed| needed > known) {
            *self = Self { damping: needed, at: Some(time) };
        }
    }
}
