//! A watched stabilizer: its corrections are checked against measurements made outside of it.

use std::cell::RefCell;
use std::rc::Rc;

use lyapunov::laws::Law;
use lyapunov::{Correction, PortSample, Scalar, Signal, Stabilizer};

use super::balance::{Balance, Double, Told};
use super::sight::{AXES, Axes, Sight};
use super::tally::{Tally, larger};
use super::terms::{Terms, Unsound};
use crate::files::scene::{Credit, LedgerKind, Manner, Reference, Work};

/// A stabilizer whose corrections are checked against measurements made outside of it, lane by lane.
///
/// It is in a box, so that a case is compiled once for each signal, and not for each stabilizer too.
pub(super) struct Watched<V> {
    stabilizer: Box<dyn Stabilizer<V>>,
    record: Record,
}

/// Handle to the measurements of a watched stabilizer while a loop owns the stabilizer.
#[derive(Clone, Debug)]
pub(super) struct Record(Rc<RefCell<Meters>>);

impl Record {
    /// The measurements so far, of each lane.
    pub(super) fn tallies(&self) -> Vec<Tally> {
        self.0.borrow().tallies()
    }
}

impl<V: Signal> Watched<V> {
    pub(super) fn new(stabilizer: impl Stabilizer<V> + 'static, terms: Terms) -> (Self, Record) {
        let record = Record(Rc::new(RefCell::new(Meters::new::<V::Scalar>(terms))));
        (Self { stabilizer: Box::new(stabilizer), record: record.clone() }, record)
    }
}

impl<V: Signal> Stabilizer<V> for Watched<V> {
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let correction = self.stabilizer.stabilize(sample, effort);
        self.record.0.borrow_mut().watch(sample, effort, &correction);
        correction
    }
}

/// Meters of a stabilizer's samples and corrections, one for each lane.
#[derive(Debug)]
pub(super) struct Meters(Vec<Meter>);

impl Meters {
    pub(super) fn new<T: Scalar>(terms: Terms) -> Self {
        Self(vec![Meter::new::<T>(terms); T::LANES])
    }

    /// Meters of lanes on terms of their own.
    pub(super) fn of_lanes<T: Scalar>(terms: impl IntoIterator<Item = Terms>) -> Self {
        Self(terms.into_iter().map(Meter::new::<T>).collect())
    }

    /// Adds one tick: the stabilizer's sample and effort, and its correction.
    pub(super) fn watch<V: Signal>(
        &mut self,
        sample: &PortSample<V>,
        effort: V,
        correction: &Correction<V>,
    ) {
        // Work done under other efforts, where a sample spans several periods; for a single period it is exactly zero.
        let others = sample.work - sample.applied.times(sample.displacement);
        for (lane, meter) in self.0.iter_mut().enumerate() {
            meter.watch(Sight::of(lane, sample, others, effort, correction));
        }
    }

    /// The measurements so far, of each lane.
    pub(super) fn tallies(&self) -> Vec<Tally> {
        self.0.iter().map(|meter| meter.tally).collect()
    }
}

/// Energy that a reference stores at a position and a velocity, J.
type Stored = fn(&Reference, f64, f64) -> f64;

/// The same as one lane of `T` has it: the reference is a part of what is promised, and its rounding with it.
fn stored<T: Scalar>(reference: &Reference, x: f64, v: f64) -> f64 {
    let single = T::epsilon().lane(0) == f64::from(f32::EPSILON);
    if single { reference.stored::<f32>(x, v) } else { reference.stored::<f64>(x, v) }
}

#[derive(Clone, Debug)]
struct Meter {
    terms: Terms,
    tick: u64,
    shaken: bool,
    balance: Balance,
    /// The energy that a reference stores, in the scalar of the stabilizer, J.
    stored: Stored,
    /// The energy stored in the reference on the last tick on which it was finite, J; none before the first.
    held: Option<f64>,
    /// The same on this tick.
    now: f64,
    epsilon: f64,
    tiny: f64,
    /// The smallest number of the scalar above 0: the step from number to number below the smallest normal one.
    smallest: f64,
    largest: f64,
    tally: Tally,
}

impl Meter {
    fn new<T: Scalar>(terms: Terms) -> Self {
        Self {
            tick: 0,
            stored: stored::<T>,
            shaken: false,
            now: 0.0,
            balance: Balance::new(
                T::epsilon().lane(0) / 2.0,
                T::smallest_normal().lane(0),
                terms.pledge.budget,
            ),
            held: None,
            epsilon: T::epsilon().lane(0),
            tiny: T::smallest_normal().lane(0),
            smallest: T::smallest_normal().lane(0) * T::epsilon().lane(0),
            largest: T::largest().lane(0),
            tally: Tally::default(),
            terms,
        }
    }

    fn watch(&mut self, sight: Sight) {
        self.book(&sight);
        self.judge(&sight);
        self.settle(&sight);
        self.measure(&sight);
        self.tick += 1;
    }

    fn book(&mut self, sight: &Sight) {
        let mut terms = [Double::default(); 3 * AXES + 1];
        let damping = match self.terms.pledge.credit {
            Credit::Damper { damping, beyond }
                if beyond == f64::NEG_INFINITY || sight.position.values[0] > beyond =>
            {
                damping
            }
            _ => 0.0,
        };
        for axis in 0..sight.velocity.count {
            let v = sight.velocity.values[axis];
            [terms[3 * axis], terms[3 * axis + 1]] = self.works(sight, axis);
            if damping > 0.0 {
                // Over a period that is none, nothing is credited.
                let period = sight.period.max(0.0);
                let credit = Double::product(v, v).times(period).times(damping);
                // An unknown velocity credits nothing.
                if credit.value().is_finite() {
                    terms[3 * axis + 2] = credit;
                }
            }
        }
        let stored = 3 * sight.velocity.count;
        terms[stored] = self.stored(sight).into();
        if self.terms.pledge.work == Work::Sampled && sight.accepted {
            self.balance.allow(sight.burnt());
        }
        self.balance.book(&terms[..=stored], self.held.unwrap_or_default());
    }

    /// The works along an axis that the ledger books, J.
    fn works(&self, sight: &Sight, axis: usize) -> [Double; 2] {
        let of = |axes: &Axes| axes.values[axis];
        if self.terms.pledge.work == Work::Sampled {
            let power = Double::product(of(&sight.effort), of(&sight.velocity));
            return [power.times(sight.period.max(0.0)), Double::default()];
        }
        let work = Double::product(of(&sight.applied), of(&sight.displacement));
        let others = of(&sight.others);
        // Where the applied force or the displacement is not known, the work may be.
        match (work.value() + others).is_finite() {
            true => [work, others.into()],
            false => [of(&sight.work).into(), Double::default()],
        }
    }

    /// Books what the correction is to dissipate, which sampled work takes for done.
    fn settle(&mut self, sight: &Sight) {
        if self.terms.pledge.work == Work::Sampled && sight.accepted {
            self.balance.book(&[sight.burnt().into()], 0.0);
        }
    }

    /// The credit that does not split into axes, J; where it is not finite, nothing of the tick is booked.
    fn stored(&mut self, sight: &Sight) -> f64 {
        match &self.terms.pledge.credit {
            Credit::None | Credit::Damper { .. } => 0.0,
            // What the damper dissipates over no time is unknown.
            Credit::Moved { .. } if !sight.timed() => f64::NAN,
            Credit::Moved { damping, least } => {
                let period = sight.period.max(*least);
                damping * (sight.displacement.inner(&sight.displacement) / period)
            }
            Credit::Reference(reference) => {
                let [x, v] = [sight.position.values[0], sight.velocity.values[0]];
                // Where the work is not known, neither is where the side was.
                let is_known = sight.work.finite();
                let now = if is_known { (self.stored)(reference, x, v) } else { f64::NAN };
                // Nothing is known of what was stored before the first tick: that one is where it is counted from.
                let change = self.held.unwrap_or(now) - now;
                self.now = now;
                if now.is_finite() {
                    self.held = Some(now);
                }
                change
            }
        }
    }

    fn judge(&mut self, sight: &Sight) {
        let tick = self.tick;
        let sound = sight.sound();
        // The stabilizer rejects energies and powers near the end of the scalar's range, and squares there; from then on
        // its ledger is no longer whole.
        let told = if sound { sight.energy().max(self.now.abs()) } else { 0.0 };
        let energy = told.max(self.balance.size());
        let left = energy > self.largest / 64.0 || !sound && self.terms.unsound == Unsound::Range;
        if left && self.tally.out_of_range.is_none() {
            self.tally.out_of_range = Some(tick);
        }
        let in_range = self.tally.out_of_range.is_none();
        let answers = self.terms.pledge.manner == Manner::Answers;
        let mut require = |law, kept| self.tally.require(law, kept, tick);
        let finite = sight.out.finite() && (sight.sum + sight.alpha + sight.shortfall).is_finite();
        require(if sound { Law::Finite } else { Law::Rejects }, finite);
        let usable = sight.effort.finite() && sight.timed();
        require(Law::Rejects, usable || !sight.accepted || answers);
        let recovers = sound && sight.timed() && self.shaken && in_range;
        require(Law::Recovers, !recovers || sight.accepted);
        require(Law::NoNegativeDamping, sight.alpha >= 0.0 && sight.shortfall >= 0.0);
        require(Law::WithinLimit, sight.applied.largest() <= self.terms.force || !sound);
        if sight.accepted {
            self.judge_effort(sight);
        }
        let dissipated = if sight.accepted { sight.burnt() } else { 0.0 };
        let told = Told { sum: sight.sum, dissipated, shortfall: sight.shortfall };
        let off = match self.terms.pledge.account {
            LedgerKind::None => 0.0,
            LedgerKind::Whole => self.balance.off(told),
            LedgerKind::Forgetful => self.balance.over(told),
        };
        if in_range {
            self.tally.off = larger(self.tally.off, off);
            self.tally.require(Law::Balances, off <= 1.0, tick);
        }
        self.shaken = !sound || !sight.accepted;
    }

    /// The laws of an effort that was accepted.
    fn judge_effort(&mut self, sight: &Sight) {
        let (tick, epsilon) = (self.tick, self.epsilon);
        let (least, smallest) = (self.least_damping(sight.alpha), self.smallest);
        for axis in 0..sight.velocity.count {
            let (out, given) = (sight.out.values[axis], sight.effort.values[axis]);
            let v = sight.velocity.values[axis];
            let rounding = 8.0 * epsilon * out.abs() + 8.0 * epsilon * given.abs();
            let mut require = |law, kept| self.tally.require(law, kept, tick);
            match self.terms.pledge.manner {
                Manner::Damps => {}
                Manner::Cuts => {
                    let grown = out.abs() - given.abs();
                    require(Law::NoLarger, out * given >= 0.0 && grown <= rounding);
                    continue;
                }
                Manner::Directs | Manner::Follows | Manner::Answers => continue,
            }
            let most = self.terms.limit * v.abs() * (1.0 + 8.0 * epsilon);
            require(Law::Opposes, (out - given) * v >= -rounding * v.abs());
            require(Law::WithinLimit, (out - given).abs() <= most + rounding + smallest);
            require(Law::Injects, (out - given).abs() >= least * v.abs() - rounding - self.tiny);
            let correction = (out - given).abs() / most.max(rounding).max(self.tiny);
            self.tally.correction = larger(self.tally.correction, correction);
        }
        if self.terms.pledge.manner == Manner::Directs {
            self.judge_direction(sight);
        }
        let served = sight.sum + sight.burnt() + sight.shortfall;
        let rounding = 16.0 * epsilon * sight.sum.abs() + self.tiny;
        let in_range = self.tally.out_of_range.is_none();
        self.tally.require(Law::Served, served >= -rounding || !in_range, tick);
    }

    /// The least damping that a told one of `alpha` N·s/m may stand for, as it is rounded: by a share of itself, and below
    /// the smallest normal number by as much as there.
    fn least_damping(&self, alpha: f64) -> f64 {
        // By addition, and 0 where nothing is asked for: a product with such a number takes a hundred times as long.
        let twice = self.smallest + self.smallest;
        let least = alpha * (1.0 - 16.0 * self.epsilon) - twice - twice;
        if least < 0.0 { 0.0 } else { least }
    }

    /// The same laws of a correction as a vector.
    fn judge_direction(&mut self, sight: &Sight) {
        let Sight { out, effort, velocity, .. } = sight;
        let added = out.minus(effort);
        let (speed, along) = (velocity.length(), added.along(velocity));
        let rounding = 8.0 * self.epsilon * out.length() + 8.0 * self.epsilon * effort.length();
        let most = self.terms.limit * speed * (1.0 + 8.0 * self.epsilon);
        self.tally.require(Law::Opposes, along >= -rounding, self.tick);
        let within = added.length() <= most + rounding + self.smallest + self.smallest;
        self.tally.require(Law::WithinLimit, within, self.tick);
        let told = self.least_damping(sight.alpha) * speed;
        self.tally.require(Law::Injects, along >= told - rounding - self.tiny / speed, self.tick);
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
        tally.given = larger(tally.given, self.terms.pledge.budget - self.balance.supplied());
        tally.shortfall = larger(tally.shortfall, sight.shortfall);
        tally.peak_force = larger(tally.peak_force, sight.out.largest());
        if sight.applied.finite() {
            tally.acting = larger(tally.acting, sight.applied.largest());
        }
    }
}
