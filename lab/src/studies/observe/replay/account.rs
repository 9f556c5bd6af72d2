//! Account of one stabilizer over a log.

use std::collections::VecDeque;

use lyapunov::PortSample;
use lyapunov::accumulators::{Accumulator, Compensated};

use super::Replayed;
use super::entrant::{self, Answer, Entrant};
use crate::files::Scene;
use crate::files::log::Sample;
use crate::show::envelope::Envelope;
use crate::simulate::family::StabilizerName;

/// Account of one stabilizer, row by row.
#[derive(Debug)]
pub(super) struct Account {
    member: StabilizerName,
    entrant: Entrant,
    told: Replayed,
    /// Corrections that have not acted yet: a force of the scene acts late by as many ticks, and one more.
    pending: VecDeque<f64>,
    /// The correction that acts until the next row, N.
    acting: f64,
    taken: Compensated<f64>,
    port: Compensated<f64>,
    squares: Compensated<f64>,
    added: Envelope,
}

impl Account {
    /// A stabilizer before the first row, whose corrections act `delay` ticks late.
    pub(super) fn new(member: StabilizerName, entrant: Entrant, delay: u32) -> Self {
        let zero = Compensated::zero();
        Self {
            member,
            entrant,
            told: Replayed::of(member.name()),
            pending: std::iter::repeat_n(0.0, delay as usize).collect(),
            acting: 0.0,
            taken: zero,
            port: zero,
            squares: zero,
            added: Envelope::new(),
        }
    }

    /// Begins with the first row: what is stored there is none of what its port gives.
    pub(super) fn begin(&mut self, scene: &Scene, first: &PortSample<f64>) {
        let start = [first.position, first.velocity];
        if let Some(entrant) = entrant::started(self.member, scene, start) {
            self.entrant = entrant;
        }
    }

    /// Adds a row that the recorded `sample` leads to: its force is held until the next one.
    pub(super) fn add(&mut self, sample: &PortSample<f64>, row: &Sample) {
        let gained = self.acting * sample.displacement;
        self.taken.add(gained);
        self.port.add(sample.work + gained);
        let sample = PortSample {
            applied: sample.applied + self.acting,
            work: sample.work + gained,
            ..*sample
        };
        let answer = self.entrant.answer(&sample, row.commanded);
        self.pending.push_back(answer.added);
        self.acting = self.pending.pop_front().unwrap_or(0.0);
        self.squares.add(answer.added * answer.added);
        self.added.add(row.t, answer.added);
        self.tell(row.t, &answer);
    }

    fn tell(&mut self, time: f64, answer: &Answer) {
        let told = &mut self.told;
        let size = answer.added.abs();
        told.ticks += 1;
        if size > 0.0 {
            told.active_ticks += 1;
            told.first_at.get_or_insert(time);
        }
        if size > told.largest_force {
            (told.largest_force, told.largest_force_at) = (size, Some(time));
        }
        if answer.shortfall > told.shortfall {
            (told.shortfall, told.shortfall_at) = (answer.shortfall, Some(time));
        }
        told.rejected += u64::from(!answer.accepted);
        told.energy_given = told.energy_given.max(-self.port.value());
    }

    /// Its row and its curve.
    pub(super) fn finish(self) -> (Replayed, Envelope) {
        let ticks = self.told.ticks.max(1) as f64;
        let told = Replayed {
            active_percent: 100.0 * self.told.active_ticks as f64 / ticks,
            rms_force: (self.squares.value() / ticks).sqrt(),
            energy_taken: self.taken.value(),
            ..self.told
        };
        (told, self.added)
    }
}
