//! Witness of what a stabilizer answers under faults.

use std::fmt;

use lyapunov::laws::Law;
use lyapunov::{Correction, Mask, PortSample, Signal};

use super::RECOVERY;
use super::fault::Fault;
use crate::files::scene::Manner;
use crate::studies::hard::sight::Axes;
use crate::studies::hard::tally::larger;
use crate::studies::hard::terms::Terms;
use crate::studies::hard::watched::Meters;

/// Promise that a stabilizer did not keep under faults.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Broken {
    /// A law of the port.
    Law(Law),
    /// A rejected sample has no force.
    NoForce,
    /// A force is at most what was asked, and the limit times the speed.
    Bound,
    /// A number of ticks after a fault every sample is accepted.
    Recovery,
}

impl fmt::Display for Broken {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Law(law) => law.fmt(f),
            Self::NoForce => f.write_str("a sample that is rejected must have no force"),
            Self::Bound => {
                f.write_str("a force must be at most what was asked plus the limit times the speed")
            }
            Self::Recovery => {
                write!(f, "{RECOVERY} ticks after a fault every sample must be accepted")
            }
        }
    }
}

/// Witness of the samples that a stabilizer was told, and of its answers.
#[derive(Debug)]
pub(super) struct Witness {
    meters: Meters,
    limit: f64,
    answers: bool,
    /// The ticks so far.
    tick: u64,
    /// Ticks since the last fault.
    since: Option<u64>,
    asked: f64,
    fastest: f64,
    /// The faults so far.
    pub(super) faults: u64,
    /// The most ticks after a fault until every sample is accepted.
    pub(super) recovery: u64,
    /// The first promise beside the laws that was broken, and the tick.
    broken: Option<(Broken, u64)>,
}

impl Witness {
    /// A witness of one run on `terms`.
    pub(super) fn new<V: Signal>(terms: Terms) -> Self {
        Self {
            limit: terms.limit,
            answers: terms.pledge.manner == Manner::Answers,
            meters: Meters::new::<V::Scalar>(terms),
            tick: 0,
            since: None,
            asked: 0.0,
            fastest: 0.0,
            faults: 0,
            recovery: 0,
            broken: None,
        }
    }

    /// The first promise that was broken, and the tick that was told when it was.
    pub(super) fn broken(&self) -> Option<(Broken, u64)> {
        let law = self.meters.tallies().first().and_then(|tally| tally.broken);
        law.map(|(law, tick)| (Broken::Law(law), tick)).or(self.broken)
    }

    /// Adds a tick that was dropped.
    pub(super) fn miss(&mut self) {
        self.since = Some(0);
        self.faults += 1;
    }

    /// Adds a tick that was told.
    pub(super) fn see<V: Signal>(
        &mut self,
        fault: Option<Fault>,
        sample: &PortSample<V>,
        asked: V,
        told: &Correction<V>,
    ) {
        self.meters.watch(sample, asked, told);
        self.since = match fault {
            Some(_) => Some(0),
            None => self.since.map(|ticks| ticks + 1),
        };
        self.faults += u64::from(fault.is_some());
        let in_range = self.meters.tallies().iter().all(|tally| tally.out_of_range.is_none());
        let sound = sample.sound().all() && asked.finite().all() && in_range;
        let accepted = told.accepted.all();
        if let Some(since) = self.since
            && !accepted
            && in_range
        {
            self.recovery = self.recovery.max(since + 1);
            self.require(!sound || since < RECOVERY, Broken::Recovery);
        }
        let force = Axes::of(told.effort, 0);
        self.require(accepted || self.answers || force.largest() == 0.0, Broken::NoForce);
        let grown = |most: f64, signal: V| {
            let length = Axes::of(signal, 0).length();
            if length.is_finite() { larger(most, length) } else { most }
        };
        self.asked = grown(self.asked, asked);
        self.fastest = grown(self.fastest, sample.velocity);
        let bound = (self.asked + self.limit * self.fastest) * (1.0 + 1e-5);
        self.require(self.answers || force.largest() <= bound, Broken::Bound);
        self.tick += 1;
    }

    fn require(&mut self, kept: bool, promise: Broken) {
        if !kept && self.broken.is_none() {
            self.broken = Some((promise, self.tick));
        }
    }
}
