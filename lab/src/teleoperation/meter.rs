//! What is measured along a run.

use super::contestant::Contestant;
use super::score::{Curves, Outcome, Score};
use super::teleoperator::Teleoperator;
use crate::compare::Trace;

/// How many times the energy that the hand began with may be found in the two devices, the hand's spring and the wall, in
/// a run that counts as bounded: 4, which is twice as far or as fast.
pub const BOUND: f64 = 4.0;

/// The least that a correction burns on a tick that counts as active, of the energy at the start: at rest, debts of the last
/// digits come and go.
const ACTIVE: f64 = 1e-9;

/// Millimetres of a metre, millijoules of a joule.
const MILLI: f64 = 1e3;

/// One tick of a run: positions and velocities in m and m/s, the force on the master in N.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tick {
    pub(super) master: [f64; 2],
    pub(super) slave: [f64; 2],
    /// Where the slave is wanted.
    pub(super) command: f64,
    pub(super) felt: f64,
    /// What has crossed both ports, J.
    pub(super) crossed: f64,
    /// What the corrections at master and slave are about to burn, J.
    pub(super) burnt: [f64; 2],
    /// The debt of both ends that could not be served, J.
    pub(super) shortfall: f64,
}

impl Tick {
    /// What both ports have absorbed once the corrections are made, J.
    fn kept(&self) -> f64 {
        self.crossed + self.burnt[0] + self.burnt[1]
    }

    pub(super) fn is_finite(&self) -> bool {
        let moved = self.master.iter().chain(&self.slave).all(|it| it.is_finite());
        moved
            && [self.command, self.felt, self.kept(), self.shortfall]
                .iter()
                .all(|it| it.is_finite())
    }
}

/// Everything that is measured along a run.
#[derive(Debug)]
pub(super) struct Meter<'a> {
    file: &'a Teleoperator,
    ticks: u64,
    active: [u64; 2],
    energy: f64,
    speed: f64,
    error: f64,
    felt: f64,
    contact: f64,
    kept: f64,
    shortfall: f64,
    last: Option<Tick>,
    master: Trace,
    slave: Trace,
}

impl<'a> Meter<'a> {
    pub(super) fn new(file: &'a Teleoperator) -> Self {
        let [energy, speed, error, felt, contact, kept, shortfall] = [0.0; 7];
        Self {
            file,
            ticks: 0,
            active: [0; 2],
            energy,
            speed,
            error,
            felt,
            contact,
            kept,
            shortfall,
            last: None,
            master: Trace::new(file.ticks()),
            slave: Trace::new(file.ticks()),
        }
    }

    /// Ticks so far.
    pub(super) fn ticks(&self) -> u64 {
        self.ticks
    }

    pub(super) fn add(&mut self, tick: Tick) {
        let ([x, v], [y, w]) = (tick.master, tick.slave);
        let t = self.ticks as f64 / self.file.servo_rate.get();
        self.master.add(t, x);
        self.slave.add(t, y);
        let (master, slave) = (&self.file.master, &self.file.slave);
        let depth = slave.wall.map_or(0.0, |wall| (y - wall.position.get()).max(0.0));
        let contact = slave.wall.map_or(0.0, |wall| wall.stiffness.get() * depth);
        let kinetic = master.mass.get() * v * v + slave.mass.get() * w * w;
        let stored = 0.5 * (kinetic + master.hand_stiffness.get() * x * x + contact * depth);
        self.energy = self.energy.max(stored);
        // The last tenth of the run.
        if 10 * self.ticks >= 9 * self.file.ticks() {
            self.speed = self.speed.max(v.abs()).max(w.abs());
        }
        self.error = self.error.max((x - y).abs());
        self.felt = self.felt.max(tick.felt.abs());
        self.contact = self.contact.max(contact);
        self.kept = self.kept.min(tick.kept());
        self.shortfall = self.shortfall.max(tick.shortfall);
        let least = ACTIVE * self.file.stored_at_start();
        for (count, burnt) in self.active.iter_mut().zip(tick.burnt) {
            *count += u64::from(burnt > least);
        }
        self.ticks += 1;
        self.last = Some(tick);
    }

    pub(super) fn finish(self, contestant: Contestant) -> Outcome {
        let complete = self.ticks == self.file.ticks() + 1;
        let told = |value: f64| Some(value).filter(|value| complete && value.is_finite());
        let end = |of: fn(&Tick) -> f64| self.last.as_ref().map(of).and_then(|it| told(MILLI * it));
        let share = |count: u64| 100.0 * count as f64 / self.ticks.max(1) as f64;
        let score = Score {
            stabilizer: contestant.name(),
            bounded: complete && self.energy <= BOUND * self.file.stored_at_start(),
            energy: told(MILLI * self.energy),
            speed: told(MILLI * self.speed),
            error: told(MILLI * self.error),
            error_end: end(|tick| tick.master[0] - tick.slave[0]),
            drift: end(|tick| tick.command - tick.master[0]),
            felt: told(self.felt),
            contact: self.file.slave.wall.and_then(|_| told(self.contact)),
            kept: told(MILLI * self.kept),
            shortfall: told(MILLI * self.shortfall),
            active_master: share(self.active[0]),
            active_slave: share(self.active[1]),
        };
        let curves = Curves { master: self.master.finish(), slave: self.slave.finish() };
        Outcome { contestant, score, curves }
    }
}
