//! A stabilizer with somebody looking on.

use std::cell::RefCell;
use std::rc::Rc;

use lyapunov::laws::Law;
use lyapunov::{Action, Drive, Mask, Scalar, Signal, Stabilizer};

use super::balance::{Balance, Told};
use super::double::Double;
use super::tally::{Tally, larger};

/// What has to be known to judge a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Terms {
    /// Ticks in all.
    pub(super) ticks: u64,
    /// Where swings are counted from, m.
    pub(super) rest: f64,
    /// The most damping, N·s/m.
    pub(super) limit: f64,
    /// The credited damping, N·s/m.
    pub(super) damping: f64,
    /// It counts beyond here only, m.
    pub(super) beyond: f64,
    /// The most that may act, N.
    pub(super) force: f64,
}

impl Terms {
    /// Of a run that credits nothing and clips nothing.
    pub(super) fn of(ticks: u64, limit: f64) -> Self {
        let (rest, damping) = (0.0, 0.0);
        Self { ticks, rest, limit, damping, beyond: f64::NEG_INFINITY, force: f64::INFINITY }
    }
}

/// A stabilizer that is watched: its words are held against what is measured beside it, lane by lane.
#[derive(Debug)]
pub(super) struct Watched<S> {
    stabilizer: S,
    record: Record,
}

/// Where the measurements of a watched stabilizer are read while a loop owns it.
#[derive(Clone, Debug)]
pub(super) struct Record(Rc<RefCell<Vec<Meter>>>);

impl Record {
    /// The measurements so far, of each lane.
    pub(super) fn tallies(&self) -> Vec<Tally> {
        self.0.borrow().iter().map(|meter| meter.tally).collect()
    }
}

impl<S> Watched<S> {
    pub(super) fn new<T: Scalar>(stabilizer: S, terms: Terms) -> (Self, Record) {
        let meter = Meter {
            terms,
            tick: 0,
            shaken: false,
            balance: Balance::new(T::epsilon().lane(0) / 2.0, T::tiny().lane(0)),
            epsilon: T::epsilon().lane(0),
            tiny: T::tiny().lane(0),
            tally: Tally::default(),
        };
        let record = Record(Rc::new(RefCell::new(vec![meter; T::LANES])));
        (Self { stabilizer, record: record.clone() }, record)
    }
}

impl<V: Signal, S: Stabilizer<V>> Stabilizer<V> for Watched<S> {
    fn stabilize(&mut self, drive: &Drive<V>, effort: V) -> Action<V> {
        let action = self.stabilizer.stabilize(drive, effort);
        // What several periods under other efforts did; of a single one this is exactly zero.
        let others = drive.work - drive.acted.times(drive.displacement);
        for (lane, meter) in self.record.0.borrow_mut().iter_mut().enumerate() {
            meter.watch(Sight::of(lane, drive, others, effort, &action));
        }
        action
    }
}

/// As many axes as a port may have here.
const AXES: usize = 4;

/// A signal, axis by axis.
#[derive(Clone, Copy, Debug)]
struct Axes {
    values: [f64; AXES],
    count: usize,
}

impl Axes {
    fn of<V: Signal>(signal: V, lane: usize) -> Self {
        let (mut values, mut count) = ([0.0; AXES], 0);
        signal.map(|axis| {
            values[count] = axis.lane(lane);
            count += 1;
            axis
        });
        Self { values, count }
    }

    fn finite(&self) -> bool {
        self.all().iter().all(|axis| axis.is_finite())
    }

    fn all(&self) -> &[f64] {
        &self.values[..self.count]
    }

    fn pair(&self, other: &Self) -> f64 {
        self.all().iter().zip(other.all()).map(|(a, b)| a * b).sum()
    }

    fn largest(&self) -> f64 {
        self.farthest(0.0)
    }

    /// The largest distance of an axis from `rest`.
    fn farthest(&self, rest: f64) -> f64 {
        self.all().iter().fold(0.0, |most, axis| larger(most, (axis - rest).abs()))
    }
}

/// One tick of one lane.
#[derive(Clone, Copy, Debug)]
struct Sight {
    period: f64,
    position: Axes,
    velocity: Axes,
    displacement: Axes,
    acted: Axes,
    work: Axes,
    others: Axes,
    effort: Axes,
    out: Axes,
    sum: f64,
    alpha: f64,
    shortfall: f64,
    accepted: bool,
}

impl Sight {
    fn of<V: Signal>(
        lane: usize,
        drive: &Drive<V>,
        others: V,
        effort: V,
        action: &Action<V>,
    ) -> Self {
        Self {
            period: drive.period.lane(lane),
            position: Axes::of(drive.position, lane),
            velocity: Axes::of(drive.velocity, lane),
            displacement: Axes::of(drive.displacement, lane),
            acted: Axes::of(drive.acted, lane),
            work: Axes::of(drive.work, lane),
            others: Axes::of(others, lane),
            effort: Axes::of(effort, lane),
            out: Axes::of(action.effort, lane),
            sum: action.sum.lane(lane),
            alpha: action.alpha.lane(lane),
            shortfall: action.shortfall.lane(lane),
            accepted: action.accepted.lane(lane),
        }
    }

    fn sound(&self) -> bool {
        let drive = [&self.position, &self.velocity, &self.displacement, &self.acted, &self.work];
        self.period.is_finite() && self.effort.finite() && drive.iter().all(|axes| axes.finite())
    }

    /// `v² T`, J per N·s/m.
    fn square(&self) -> f64 {
        self.velocity.pair(&self.velocity) * self.period
    }
}

#[derive(Clone, Copy, Debug)]
struct Meter {
    terms: Terms,
    tick: u64,
    shaken: bool,
    balance: Balance,
    epsilon: f64,
    tiny: f64,
    tally: Tally,
}

impl Meter {
    fn watch(&mut self, sight: Sight) {
        self.book(&sight);
        self.judge(&sight);
        self.measure(&sight);
        self.tick += 1;
    }

    fn book(&mut self, sight: &Sight) {
        let mut terms = [Double::default(); 3 * AXES];
        let credits = self.terms.damping > 0.0 && sight.position.values[0] > self.terms.beyond;
        for axis in 0..sight.velocity.count {
            let work = Double::product(sight.acted.values[axis], sight.displacement.values[axis]);
            let v = sight.velocity.values[axis];
            let others = sight.others.values[axis];
            // What acted or moved is not known, but the work is.
            let known = (work.value() + others).is_finite();
            terms[3 * axis] = if known { work } else { sight.work.values[axis].into() };
            terms[3 * axis + 1] = if known { others.into() } else { Double::default() };
            if credits {
                let credit = Double::product(v, v).times(sight.period).times(self.terms.damping);
                terms[3 * axis + 2] = credit;
            }
        }
        self.balance.book(&terms);
    }

    fn judge(&mut self, sight: &Sight) {
        let (tick, epsilon) = (self.tick, self.epsilon);
        let sound = sight.sound();
        let mut correction = 0.0;
        let mut require = |law, kept| self.tally.require(law, kept, tick);
        let finite = sight.out.finite() && (sight.sum + sight.alpha + sight.shortfall).is_finite();
        require(if sound { Law::Finite } else { Law::Rejects }, finite);
        require(Law::Rejects, sight.effort.finite() || !sight.accepted);
        require(Law::Recovers, !(sound && self.shaken) || sight.accepted);
        require(Law::NoNegativeDamping, sight.alpha >= 0.0 && sight.shortfall >= 0.0);
        if sight.accepted {
            for axis in 0..sight.velocity.count {
                let [out, given, v] =
                    [&sight.out, &sight.effort, &sight.velocity].map(|a| a.values[axis]);
                let rounding = 8.0 * epsilon * (out.abs() + given.abs());
                let most = self.terms.limit * v.abs() * (1.0 + 8.0 * epsilon);
                correction =
                    larger(correction, (out - given).abs() / most.max(rounding).max(self.tiny));
                require(Law::Opposes, (out - given) * v >= -rounding * v.abs());
                require(Law::WithinLimit, (out - given).abs() <= most + rounding);
            }
            let served = sight.sum + sight.alpha * sight.square() + sight.shortfall;
            let rounding = 16.0 * epsilon * sight.sum.abs() + self.tiny;
            require(Law::Served, served >= -rounding);
        }
        require(Law::WithinLimit, sight.acted.largest() <= self.terms.force || !sound);
        let dissipated = match sight.accepted {
            true => sight.alpha * sight.square(),
            false => 0.0,
        };
        let told = Told { sum: sight.sum, dissipated, shortfall: sight.shortfall };
        let off = self.balance.off(told);
        self.tally.off = larger(self.tally.off, off);
        self.tally.require(Law::Balances, off <= 1.0, tick);
        self.tally.correction = larger(self.tally.correction, correction);
        self.shaken = !sound;
    }

    fn measure(&mut self, sight: &Sight) {
        let tally = &mut self.tally;
        if tally.not_finite.is_none() && !sight.out.finite() {
            tally.not_finite = Some(self.tick);
        }
        if sight.position.finite() {
            let away = sight.position.farthest(self.terms.rest);
            tally.swing = larger(tally.swing, away);
            if 4 * self.tick >= 3 * self.terms.ticks {
                tally.late_swing = larger(tally.late_swing, away);
            }
        }
        tally.given = larger(tally.given, -self.balance.supplied());
        tally.shortfall = larger(tally.shortfall, sight.shortfall);
        tally.peak_force = larger(tally.peak_force, sight.out.largest());
        if sight.acted.finite() {
            tally.acting = larger(tally.acting, sight.acted.largest());
        }
    }
}
