//! A watched stabilizer: its corrections are checked against measurements made outside of it.

use std::cell::RefCell;
use std::rc::Rc;

use lyapunov::laws::Law;
use lyapunov::{Correction, Mask, PortSample, Scalar, Signal, Stabilizer};

use super::balance::{Balance, Double, Told};
use super::tally::{Tally, larger};
use crate::files::scene::{Credit, LedgerKind, Manner, Pledge};

/// The numbers and promises that a run is judged by.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Terms {
    /// Ticks in all.
    pub(super) ticks: u64,
    /// The position that swings are measured from, m.
    pub(super) rest: f64,
    /// The damping limit, N·s/m.
    pub(super) limit: f64,
    /// The promises of the stabilizer.
    pub(super) pledge: Pledge,
    /// The largest force that may be applied, N.
    pub(super) force: f64,
}

impl Terms {
    /// Terms of a run under POPC in which nothing saturates.
    pub(super) fn of(ticks: u64, limit: f64) -> Self {
        Self { ticks, rest: 0.0, limit, pledge: Pledge::POPC, force: f64::INFINITY }
    }
}

/// A stabilizer whose corrections are checked against measurements made outside of it, lane by lane.
#[derive(Debug)]
pub(super) struct Watched<S> {
    stabilizer: S,
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

impl<S> Watched<S> {
    pub(super) fn new<T: Scalar>(stabilizer: S, terms: Terms) -> (Self, Record) {
        let record = Record(Rc::new(RefCell::new(Meters::new::<T>(terms))));
        (Self { stabilizer, record: record.clone() }, record)
    }
}

impl<V: Signal, S: Stabilizer<V>> Stabilizer<V> for Watched<S> {
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

/// The most axes that a port may have here.
const AXES: usize = 4;

/// The axes of a signal in one lane.
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

    fn inner(&self, other: &Self) -> f64 {
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
    applied: Axes,
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
        sample: &PortSample<V>,
        others: V,
        effort: V,
        correction: &Correction<V>,
    ) -> Self {
        Self {
            period: sample.period.lane(lane),
            position: Axes::of(sample.position, lane),
            velocity: Axes::of(sample.velocity, lane),
            displacement: Axes::of(sample.displacement, lane),
            applied: Axes::of(sample.applied, lane),
            work: Axes::of(sample.work, lane),
            others: Axes::of(others, lane),
            effort: Axes::of(effort, lane),
            out: Axes::of(correction.effort, lane),
            sum: correction.observed_energy.lane(lane),
            alpha: correction.alpha.lane(lane),
            shortfall: correction.shortfall.lane(lane),
            accepted: correction.accepted.lane(lane),
        }
    }

    fn sound(&self) -> bool {
        let sample =
            [&self.position, &self.velocity, &self.displacement, &self.applied, &self.work];
        self.period.is_finite() && self.effort.finite() && sample.iter().all(|axes| axes.finite())
    }

    /// `v² T`, J per N·s/m.
    fn square(&self) -> f64 {
        self.velocity.inner(&self.velocity) * self.period
    }

    /// Energy that the correction is to dissipate, J: nothing without damping, whatever the velocity.
    fn burnt(&self) -> f64 {
        if self.alpha == 0.0 { 0.0 } else { self.alpha * self.square() }
    }
}

#[derive(Clone, Debug)]
struct Meter {
    terms: Terms,
    tick: u64,
    shaken: bool,
    balance: Balance,
    /// The energy stored in the reference on the tick before, J.
    held: f64,
    epsilon: f64,
    tiny: f64,
    largest: f64,
    tally: Tally,
}

impl Meter {
    fn new<T: Scalar>(terms: Terms) -> Self {
        Self {
            tick: 0,
            shaken: false,
            balance: Balance::new(
                T::epsilon().lane(0) / 2.0,
                T::smallest_normal().lane(0),
                terms.pledge.budget,
            ),
            held: match &terms.pledge.credit {
                Credit::Reference { reference, start: [x, v] } => reference.stored(*x, *v),
                _ => 0.0,
            },
            epsilon: T::epsilon().lane(0),
            tiny: T::smallest_normal().lane(0),
            largest: T::largest().lane(0),
            tally: Tally::default(),
            terms,
        }
    }

    fn watch(&mut self, sight: Sight) {
        self.book(&sight);
        self.judge(&sight);
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
            let work = Double::product(sight.applied.values[axis], sight.displacement.values[axis]);
            let v = sight.velocity.values[axis];
            let others = sight.others.values[axis];
            // Where the applied force or the displacement is not known, the work may be.
            let known = (work.value() + others).is_finite();
            terms[3 * axis] = if known { work } else { sight.work.values[axis].into() };
            terms[3 * axis + 1] = if known { others.into() } else { Double::default() };
            if damping > 0.0 {
                let credit = Double::product(v, v).times(sight.period).times(damping);
                // An unknown velocity credits nothing.
                if credit.value().is_finite() {
                    terms[3 * axis + 2] = credit;
                }
            }
        }
        terms[3 * AXES] = self.stored(sight).into();
        self.balance.book(&terms, self.held);
    }

    /// The credit that does not split into axes, J; where it is not finite, nothing of the tick is booked.
    fn stored(&mut self, sight: &Sight) -> f64 {
        match &self.terms.pledge.credit {
            Credit::None | Credit::Damper { .. } => 0.0,
            Credit::Moved { damping } => {
                damping * (sight.displacement.inner(&sight.displacement) / sight.period)
            }
            Credit::Reference { reference, .. } => {
                let now = reference.stored(sight.position.values[0], sight.velocity.values[0]);
                let change = self.held - now;
                if now.is_finite() {
                    self.held = now;
                }
                change
            }
        }
    }

    fn judge(&mut self, sight: &Sight) {
        let (tick, epsilon) = (self.tick, self.epsilon);
        let sound = sight.sound();
        let mut correction = 0.0;
        // The stabilizer rejects energies near the end of the scalar's range, and squared velocities there; from then
        // on its ledger is no longer whole.
        let told =
            if sound { sight.velocity.inner(&sight.velocity).max(sight.square()) } else { 0.0 };
        let energy = told.max(self.balance.size());
        if energy > self.largest / 64.0 && self.tally.out_of_range.is_none() {
            self.tally.out_of_range = Some(tick);
        }
        let in_range = self.tally.out_of_range.is_none();
        let mut require = |law, kept| self.tally.require(law, kept, tick);
        let finite = sight.out.finite() && (sight.sum + sight.alpha + sight.shortfall).is_finite();
        require(if sound { Law::Finite } else { Law::Rejects }, finite);
        require(Law::Rejects, sight.effort.finite() || !sight.accepted);
        require(Law::Recovers, !(sound && self.shaken && in_range) || sight.accepted);
        require(Law::NoNegativeDamping, sight.alpha >= 0.0 && sight.shortfall >= 0.0);
        if sight.accepted {
            for axis in 0..sight.velocity.count {
                let [out, given, v] =
                    [&sight.out, &sight.effort, &sight.velocity].map(|a| a.values[axis]);
                let rounding = 8.0 * epsilon * (out.abs() + given.abs());
                match self.terms.pledge.manner {
                    Manner::Damps => {}
                    Manner::Cuts => {
                        let grown = out.abs() - given.abs();
                        require(Law::NoLarger, out * given >= 0.0 && grown <= rounding);
                        continue;
                    }
                    Manner::Follows => continue,
                }
                let most = self.terms.limit * v.abs() * (1.0 + 8.0 * epsilon);
                correction =
                    larger(correction, (out - given).abs() / most.max(rounding).max(self.tiny));
                require(Law::Opposes, (out - given) * v >= -rounding * v.abs());
                require(Law::WithinLimit, (out - given).abs() <= most + rounding);
            }
            let served = sight.sum + sight.burnt() + sight.shortfall;
            let rounding = 16.0 * epsilon * sight.sum.abs() + self.tiny;
            require(Law::Served, served >= -rounding || !in_range);
        }
        require(Law::WithinLimit, sight.applied.largest() <= self.terms.force || !sound);
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
        self.tally.correction = larger(self.tally.correction, correction);
        self.shaken = !sound || !sight.accepted;
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
