//! Stabilizers that are asked what they would have done on a recorded motion.
//!
//! Each gets the log's motion and force tick by tick, and its own correction counts as applied from then on: it books the
//! work of the recorded force and of what it added, on the recorded displacement. That displacement would have been
//! another, which [`NOTE`] says wherever the numbers stand.

mod account;
mod entrant;
mod group;
mod picture;
mod replayed;
mod table;

use std::fmt::Debug;

use lyapunov::{HeldTick, PortSample};

use super::step::Step;
use crate::files::Scene;
use crate::files::log::{LogError, Sample};
use crate::simulate::family::StabilizerNames;
use crate::text::found;
use account::Account;
pub use replayed::{Left, Replay, Replayed};

/// The sentence that stands with every replay.
pub const NOTE: &str = "Had a stabilizer acted, the motion would have been another: this is what each would have answered to the \
                        recorded motion, and not what the loop would have done. lyapunov compare simulates that.";

/// Share of the scene's period by which that of the log may differ.
const NEAR: f64 = 0.1;

/// Stabilizers to ask, and the scene that sets their numbers as in a comparison.
#[derive(Clone, Debug, PartialEq)]
pub struct Asked {
    /// Who is asked.
    pub stabilizers: StabilizerNames,
    /// The scene.
    pub scene: Scene,
    /// Its name.
    pub name: String,
}

/// Listener to the steps of a log. A table of methods, so that a program in which nobody listens, as in the page, links none of it.
pub(super) trait Listener: Debug {
    /// Takes a step.
    fn book(&mut self, step: &Step, sample: &PortSample<f64>, median: f64);

    /// The answers that each stabilizer would have given.
    ///
    /// # Errors
    /// A log whose ticks are not those of the scene.
    fn finish(self: Box<Self>, name: &str, median: f64) -> Result<Replay, LogError>;
}

/// The accounts of all stabilizers over a log.
#[derive(Debug)]
pub(super) struct Replays {
    accounts: Vec<Account>,
    left: Vec<Left>,
    scene: Scene,
    /// The name of the scene.
    called: String,
    has_started: bool,
}

impl Replays {
    /// Those who are asked, before the first row.
    pub(super) fn of(asked: &Asked) -> Result<Self, LogError> {
        let (accounts, left) = entrant::entered(asked)?;
        let (scene, called) = (asked.scene.clone(), asked.name.clone());
        Ok(Self { accounts, left, scene, called, has_started: false })
    }
}

impl Listener for Replays {
    /// Tells each of them a step; the first one tells the row before it as well.
    fn book(&mut self, step: &Step, sample: &PortSample<f64>, median: f64) {
        if !std::mem::replace(&mut self.has_started, true) {
            let first = start(&step.from, median);
            self.accounts.iter_mut().for_each(|it| {
                it.begin(&self.scene, &first);
                it.add(&first, &step.from);
            });
        }
        self.accounts.iter_mut().for_each(|it| it.add(sample, &step.to));
    }

    fn finish(self: Box<Self>, name: &str, median: f64) -> Result<Replay, LogError> {
        let Self { accounts, left, scene, called, .. } = *self;
        let period = scene.period();
        if (median - period).abs() > NEAR * period {
            let [rate, apart, period] = [median.recip(), median, period].map(found);
            let told = format!(
                "the rows are {apart} s apart, and {called} has a servo period of {period} s"
            );
            return Err(LogError::about(name, told).with_help(format!(
                "a stabilizer is set for the ticks it runs at: give the scene the log's, servo_rate = {rate}, or a log \
                 with a row for each tick"
            )));
        }
        let (rows, traces) = accounts.into_iter().map(Account::finish).unzip();
        Ok(Replay { scene: called, note: NOTE, stabilizers: rows, not_replayed: left, traces })
    }
}

/// The sample of the first row: nothing has moved yet.
fn start(row: &Sample, period: f64) -> PortSample<f64> {
    let (position, velocity) = (row.x, row.v.unwrap_or(0.0));
    HeldTick { period, position, velocity, displacement: 0.0, applied: 0.0 }.sample()
}
