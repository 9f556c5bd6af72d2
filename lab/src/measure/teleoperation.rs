//! Measures along a run of a teleoperator.

use std::f64::consts::TAU;

use serde::Serialize;

use super::summary::MILLI;
use super::trace::Trace;
use super::verdict::{Findings, Verdict};
use crate::files::teleoperation::Teleoperator;
use crate::simulate::teleoperation::{Entrant, Tick};
use crate::text::names::Named;

/// The largest energy in the two devices, the hand's spring and the wall of a run that does not grow, as a multiple of the
/// hand's energy at the start: 4, which is twice as far or as fast.
pub const BOUND: f64 = 4.0;

/// The largest kinetic energy of both devices in the last tenth of a run that settles, as a multiple of the hand's energy
/// at the start: a twentieth of the speed that this would give. At rest the hand's spring may stay drawn, by drift.
pub const BAND: f64 = 0.0025;

/// The least number of swings of the hand's spring with both masses in a run that is judged.
const SWINGS: f64 = 2.0;

/// The least number of trips of a message in a run that is judged: the last tenth then has two.
const TRIPS: u64 = 20;

/// Rounding of a run's length.
const ROUNDING: f64 = 1e-9;

/// The least that a correction dissipates on a tick that counts as active, as a share of the energy at the start: at
/// rest, debts in the last digits come and go.
const ACTIVE: f64 = 1e-9;

/// Mean of what was added.
#[derive(Debug, Default)]
struct Mean {
    sum: f64,
    count: f64,
}

impl Mean {
    fn add(&mut self, value: f64) {
        self.sum += value;
        self.count += 1.0;
    }

    fn get(&self) -> f64 {
        self.sum / self.count
    }
}

/// All measures along a run.
#[derive(Debug)]
pub(crate) struct Meter<'a> {
    file: &'a Teleoperator,
    ticks: u64,
    active: [u64; 2],
    energy: f64,
    kinetic: f64,
    speed: f64,
    error: f64,
    felt: f64,
    late: Mean,
    contact: f64,
    touch: Option<f64>,
    taken: f64,
    kept: f64,
    shortfall: f64,
    last: Option<Tick>,
    master: Trace,
    slave: Trace,
}

impl<'a> Meter<'a> {
    pub(crate) fn new(file: &'a Teleoperator) -> Self {
        let [energy, kinetic, speed, error, felt, contact, taken, kept, shortfall] = [0.0; 9];
        Self {
            file,
            ticks: 0,
            active: [0; 2],
            energy,
            kinetic,
            speed,
            error,
            felt,
            late: Mean::default(),
            contact,
            touch: None,
            taken,
            kept,
            shortfall,
            last: None,
            master: Trace::new(file.ticks()),
            slave: Trace::new(file.ticks()),
        }
    }

    pub(crate) fn add(&mut self, tick: Tick) {
        let ([x, v], [y, w]) = (tick.master, tick.slave);
        let t = self.ticks as f64 / self.file.servo_rate.get();
        self.master.add(t, x);
        self.slave.add(t, y);
        let (master, slave) = (&self.file.master, &self.file.slave);
        let depth = slave.wall.map_or(0.0, |wall| (y - wall.position.get()).max(0.0));
        if depth > 0.0 {
            self.touch.get_or_insert(t);
        }
        let contact = slave.wall.map_or(0.0, |wall| wall.stiffness.get() * depth);
        let kinetic = master.mass.get() * v * v + slave.mass.get() * w * w;
        let stored = 0.5 * (kinetic + master.hand_stiffness.get() * x * x + contact * depth);
        self.energy = self.energy.max(stored);
        // The last tenth of the run.
        if 10 * self.ticks >= 9 * self.file.ticks() {
            self.speed = self.speed.max(v.abs()).max(w.abs());
            self.late.add(tick.felt);
            self.kinetic = self.kinetic.max(0.5 * kinetic);
        }
        self.error = self.error.max((x - y).abs());
        self.felt = self.felt.max(tick.felt.abs());
        self.contact = self.contact.max(contact);
        self.taken = self.taken.min(tick.taken);
        self.kept = self.kept.min(tick.kept());
        self.shortfall = self.shortfall.max(tick.shortfall);
        let least = ACTIVE * self.file.stored_at_start();
        for (count, burnt) in self.active.iter_mut().zip(tick.burnt) {
            *count += u64::from(burnt > least);
        }
        self.ticks += 1;
        self.last = Some(tick);
    }

    pub(crate) fn finish(self, entrant: Entrant) -> Outcome {
        let complete = self.ticks == self.file.ticks() + 1;
        let told = |value: f64| Some(value).filter(|value| complete && value.is_finite());
        let end = |of: fn(&Tick) -> f64| self.last.as_ref().map(of).and_then(|it| told(MILLI * it));
        let share = |count: u64| 100.0 * count as f64 / self.ticks.max(1) as f64;
        let score = Score {
            stabilizer: entrant.name(),
            verdict: Verdict::of(Findings {
                is_lost: !complete || self.energy > BOUND * self.file.stored_at_start(),
                is_short: is_short(self.file),
                grows: false,
                settles: self.kinetic <= BAND * self.file.stored_at_start(),
            }),
            energy: told(MILLI * self.energy),
            speed: told(MILLI * self.speed),
            error: told(MILLI * self.error),
            error_end: end(|tick| tick.master[0] - tick.slave[0]),
            drift: end(|tick| tick.command - tick.master[0]),
            felt: told(self.felt),
            felt_end: told(self.late.get()),
            contact: self.file.slave.wall.and_then(|_| told(self.contact)),
            touch: self.touch,
            given: told(MILLI * self.taken.abs()),
            kept: entrant.is_held_to_the_command().then(|| told(MILLI * self.kept)).flatten(),
            shortfall: told(MILLI * self.shortfall),
            active_master: share(self.active[0]),
            active_slave: share(self.active[1]),
        };
        let curves = Curves { master: self.master.finish(), slave: self.slave.finish() };
        Outcome { entrant, score, curves }
    }
}

/// Whether the runs of `file` are too short to judge.
fn is_short(file: &Teleoperator) -> bool {
    let mass = file.master.mass.get() + file.slave.mass.get();
    let swing = TAU * (mass / file.master.hand_stiffness.get()).sqrt();
    let trip = u64::from(file.channel.delay.get()) + u64::from(file.channel.spread.get()) + 1;
    let length = file.ticks() as f64 / file.servo_rate.get();
    file.ticks() < TRIPS * trip || length < SWINGS * swing * (1.0 - ROUNDING)
}

/// The result of one entrant on one teleoperator; docs/teleoperation.md defines every number.
///
/// Numbers out of range are `None`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Score {
    /// The entrant.
    pub stabilizer: &'static str,
    /// The verdict on the run, by energy: it grows beyond [`BOUND`] times the energy at the start or out of the range of the
    /// scalar, and settles where the kinetic energy stays within [`BAND`] of that at the start.
    pub verdict: Verdict,
    /// The largest energy of devices, hand and wall.
    #[serde(rename = "energy_largest_mj")]
    pub energy: Option<f64>,
    /// The largest speed of either device within the last tenth of the run.
    #[serde(rename = "speed_end_mm_per_s")]
    pub speed: Option<f64>,
    /// The largest distance between master and slave.
    #[serde(rename = "error_largest_mm")]
    pub error: Option<f64>,
    /// The distance by which the master is ahead of the slave at the last tick.
    #[serde(rename = "error_end_mm")]
    pub error_end: Option<f64>,
    /// The distance by which the commanded position is ahead of the master at the last tick.
    #[serde(rename = "drift_end_mm")]
    pub drift: Option<f64>,
    /// The largest force that the link puts on the master.
    #[serde(rename = "force_felt_n")]
    pub felt: Option<f64>,
    /// The mean force that the link puts on the master within the last tenth of the run.
    #[serde(rename = "force_end_n")]
    pub felt_end: Option<f64>,
    /// The largest force of the wall; `None` without one.
    #[serde(rename = "force_contact_n")]
    pub contact: Option<f64>,
    /// The time of the first tick within the wall, s; `None` without one.
    #[serde(rename = "first_touch_s")]
    pub touch: Option<f64>,
    /// The most that the link has given the two devices beyond what it took from them.
    #[serde(rename = "energy_given_mj")]
    pub given: Option<f64>,
    /// The least energy that the master's port and the commanded one together have absorbed, counting what corrections
    /// were about to dissipate; `None` for an entrant that keeps no account of the commanded port.
    #[serde(rename = "energy_least_mj")]
    pub kept: Option<f64>,
    /// Largest debt of both ends together that a tick could not serve.
    #[serde(rename = "shortfall_mj")]
    pub shortfall: Option<f64>,
    /// Share of the ticks on which the correction at the master dissipates more than rounding, percent.
    #[serde(rename = "active_master_percent")]
    pub active_master: f64,
    /// Share of the ticks on which the correction at the slave dissipates more than rounding, percent.
    #[serde(rename = "active_slave_percent")]
    pub active_slave: f64,
}

/// Time in s and position in m, at every tick, or for a long run the extremes of each of some thousand stretches.
#[derive(Clone, Debug, PartialEq)]
pub struct Curves {
    /// The master's.
    pub master: Vec<(f64, f64)>,
    /// The slave's.
    pub slave: Vec<(f64, f64)>,
}

/// The numbers of one entrant, and positions over time.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Outcome {
    pub(crate) entrant: Entrant,
    pub(crate) score: Score,
    pub(crate) curves: Curves,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The verdict on a run of `rows` ticks at 100 Hz in which both devices, 0.5 kg each, move at `v(t)` and `x(t)`. The
    /// hand of 100 N/m starts with 5 mJ, and two of its swings with both masses take 0.4 π s.
    fn verdict(duration: f64, delay: u16, rows: u64, x: f64, v: impl Fn(f64) -> f64) -> Verdict {
        let text = format!(
            "duration = {duration}\nservo_rate = 100.0\n\
             master = {{ mass = 0.5, hand_stiffness = 100.0, start = -0.01 }}\nslave.mass = 0.5\n\
             coordination = {{ stiffness = 200.0, damping = 2.0 }}\nchannel.delay = {delay}\n"
        );
        let file = Teleoperator::parse(&text, "test").unwrap();
        let mut meter = Meter::new(&file);
        for row in 0..rows {
            let motion = [x, v(row as f64 / 100.0)];
            let [command, felt, taken, crossed, shortfall] = [0.0; 5];
            let (master, slave, burnt) = (motion, motion, [0.0; 2]);
            meter.add(Tick { master, slave, command, felt, taken, crossed, burnt, shortfall });
        }
        meter.finish(Entrant::None).score.verdict
    }

    #[test]
    fn energies_that_decay_stay_or_pass_their_bound_are_told_apart() {
        // Both together hold 0.5 kg v²: 5 mJ at 0.1 m/s, and the band is a twentieth of that.
        let steady = |v: f64| verdict(2.0, 0, 201, 0.0, move |_| v);
        assert_eq!([0.0, 0.0049].map(steady), [Verdict::Settles; 2]);
        assert_eq!([0.0051, 0.1, 0.199].map(steady), [Verdict::Swinging; 3]);
        assert_eq!(steady(0.201), Verdict::Grows);
        // The last tenth counts, and once beyond the bound is enough.
        let stops = |at: f64| verdict(2.0, 0, 201, 0.0, move |t| if t < at { 0.1 } else { 0.0 });
        assert_eq!([1.8, 1.81].map(stops), [Verdict::Settles, Verdict::Swinging]);
        assert_eq!(
            verdict(2.0, 0, 201, 0.0, |t| if t < 0.01 { 0.21 } else { 0.0 }),
            Verdict::Grows
        );
        // At rest with a drawn spring it has settled, unless the spring holds more than four times as much.
        let drawn = |x: f64| verdict(2.0, 0, 201, x, |_| 0.0);
        assert_eq!([0.0199, 0.0201].map(drawn), [Verdict::Settles, Verdict::Grows]);
    }

    #[test]
    fn a_run_of_few_swings_or_trips_is_not_judged_unless_it_is_lost() {
        let two = 0.4 * std::f64::consts::PI;
        let last = |duration: f64| (100.0 * duration).round() as u64;
        let at = |duration: f64| verdict(duration, 0, last(duration) + 1, 0.0, |_| 0.1);
        assert_eq!([two + 0.01, two - 0.01].map(at), [Verdict::Swinging, Verdict::TooShort]);
        let delayed = |delay: u16| verdict(2.0, delay, 201, 0.0, |_| 0.1);
        assert_eq!([9, 10].map(delayed), [Verdict::Swinging, Verdict::TooShort]);
        assert_eq!(verdict(2.0, 10, 201, 0.0, |_| 0.3), Verdict::Grows);
        assert_eq!(verdict(2.0, 10, 200, 0.0, |_| 0.1), Verdict::Grows);
    }
}
