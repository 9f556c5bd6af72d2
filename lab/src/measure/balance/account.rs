//! Energies of a run by cause.

use lyapunov::effects::{Random, Source};
use lyapunov::{Scalar, Signal};
use serde::Serialize;

use super::body::{Body, Masses, Passed};
use crate::files::scene::{Scene, Velocity};
use crate::measure::law::{Law, Motion};
use crate::measure::share::{Share, Split};
use crate::simulate::{Space, Tick};

/// The energies of a stretch of a run by cause, J; docs/explain.md has the equations.
///
/// ```text
/// gained = hand + push + hold + delay + filter + encoder + saturation
///          − device − operator − link − wall − controller − friction + closing
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Balance {
    /// The time at which the stretch begins, s.
    pub from_s: f64,
    /// The time at which the stretch ends, s.
    pub to_s: f64,
    /// Gained by kinetic energy and by the springs of operator and link.
    pub gained: f64,
    /// Given by the hand, which moves its rest or changes its grip.
    pub hand: f64,
    /// Given by load and pulse.
    pub push: f64,
    /// Injected because forces are sampled and held, and the velocity is a difference.
    pub hold: f64,
    /// Injected because the force acts late.
    pub delay: f64,
    /// Injected because the velocity is filtered.
    pub filter: f64,
    /// Injected because positions are counted, or noisy.
    pub encoder: f64,
    /// Injected because the force is clipped.
    pub saturation: f64,
    /// Dissipated by the device's damper.
    pub device: f64,
    /// Dissipated by the operator's damper.
    pub operator: f64,
    /// Dissipated by the link's damper.
    pub link: f64,
    /// Taken by the environment by its own law, in continuous time: dissipated, and stored at the end.
    pub wall: f64,
    /// Taken by the stabilizer.
    pub controller: f64,
    /// Taken by friction, and moved between the dampers by jitter: the rest of the balance, where a scene has them.
    pub friction: f64,
    /// Left over: rounding.
    pub closing: f64,
}

impl Balance {
    /// The names of the parts, each with the energy that it gave; energy taken is below 0.
    pub fn parts(&self) -> [(&'static str, f64); 14] {
        [
            ("store", -self.gained),
            ("hand", self.hand),
            ("push", self.push),
            ("hold", self.hold),
            ("delay", self.delay),
            ("filter", self.filter),
            ("encoder", self.encoder),
            ("saturation", self.saturation),
            ("device", -self.device),
            ("operator", -self.operator),
            ("link", -self.link),
            ("wall", -self.wall),
            ("controller", -self.controller),
            ("friction", -self.friction),
        ]
    }

    /// The energy that the sampled loop injected, all causes together, J.
    pub fn leaked(&self) -> f64 {
        self.hold + self.delay + self.filter + self.encoder + self.saturation
    }

    /// The largest leak, with its name.
    pub fn largest_leak(&self) -> (&'static str, f64) {
        let leaks = [
            ("hold", self.hold),
            ("delay", self.delay),
            ("filter", self.filter),
            ("encoder", self.encoder),
            ("saturation", self.saturation),
        ];
        leaks.into_iter().fold(leaks[0], |one, other| if other.1 > one.1 { other } else { one })
    }

    /// Sum of the magnitudes of the parts, J.
    fn size(&self) -> f64 {
        self.parts().iter().map(|(_, part)| part.abs()).sum()
    }

    fn rest(&self) -> f64 {
        let taken = self.device + self.operator + self.link + self.wall + self.controller;
        self.gained - (self.hand + self.push + self.leaked() - taken)
    }

    fn is_finite(&self) -> bool {
        self.rest().is_finite()
    }
}

/// One tick, as a balance needs it.
#[derive(Clone, Copy, Debug)]
struct Moment<V> {
    masses: Masses<V>,
    measured: V,
    estimated: V,
    environment: V,
    acting: V,
    split: Split<V>,
}

/// Balance that grows tick by tick.
pub(super) struct Account<V: Signal> {
    scene: Scene,
    law: Law<V>,
    body: Body,
    /// The time that the plant moves from one tick to the next, s.
    span: Box<dyn FnMut() -> f64>,
    share: Share<V>,
    ticks: u64,
    last: Option<(Moment<V>, Samples<V>)>,
    whole: Balance,
    /// The magnitudes of all energies moved and, tick by tick, stored, J.
    moved: f64,
    first: Option<Balance>,
    touching: bool,
    left: bool,
}

/// Motions that the law is evaluated on, from the measured to the true one.
#[derive(Clone, Copy, Debug)]
struct Samples<V> {
    filtered: Motion<V>,
    counted: Motion<V>,
    truly: Motion<V>,
}

impl<V: Space<Scalar = f64>> Account<V> {
    /// The account of a run of `scene` in the scalar of `S`.
    pub(super) fn new<S: Space<Double = V>>(scene: &Scene, body: Body) -> Self {
        Self {
            body,
            span: spans::<S::Scalar>(scene),
            share: Share::new::<S>(scene),
            ticks: 0,
            last: None,
            whole: Balance::default(),
            moved: 0.0,
            first: None,
            touching: false,
            left: false,
            law: Law::of(scene),
            scene: scene.clone(),
        }
    }

    /// Books one more tick; false once the numbers are out of range.
    pub(super) fn add<S: Space<Double = V>>(&mut self, tick: &Tick<S>) -> bool {
        let tick = Moment {
            masses: Masses::at(tick),
            measured: tick.measured.position.double(),
            estimated: tick.measured.velocity.double(),
            environment: tick.environment.double(),
            acting: tick.applied.double(),
            split: self.share.split(tick),
        };
        let samples = self.samples(&tick);
        let none = V::zero();
        let touches = tick.environment != none || self.law.force(samples.truly) != none;
        if let Some((last, before)) = self.last {
            let moved = self.moved(&last, &before, &tick, &samples);
            if touches && self.first.is_none() {
                // The plant met the surface on the way here.
                let from_s = before.truly.time;
                self.first = Some(Balance { from_s, ..Balance::default() });
            }
            let mut whole = self.whole;
            book(&mut whole, &moved, samples.truly.time);
            if !whole.is_finite() {
                return false;
            }
            self.whole = whole;
            self.moved += moved.size();
            if let Some(first) = self.first.as_mut().filter(|_| !self.left) {
                book(first, &moved, samples.truly.time);
            }
        }
        if touches && self.last.is_none() {
            self.first = Some(Balance::default());
        }
        // A force still on its way belongs to the contact.
        let acts = tick.acting != none || tick.split.late != none || self.share.is_waiting();
        self.left |= self.touching && !touches && !acts;
        self.touching |= touches;
        self.last = Some((tick, samples));
        self.ticks += 1;
        true
    }

    /// The magnitudes of all energies moved and, tick by tick, stored, J: what rounding is to be measured by.
    pub(super) fn size(&self) -> f64 {
        self.moved
    }

    /// The balance of the whole run and, if there was one, of the first contact.
    pub(super) fn finish(self) -> (Balance, Option<Balance>) {
        let has_rest = self.scene.effects.friction.is_some() || self.scene.effects.jitter.is_some();
        let close = |balance: Balance| {
            let rest = balance.rest();
            if has_rest {
                Balance { friction: -rest, ..balance }
            } else {
                Balance { closing: rest, ..balance }
            }
        };
        (close(self.whole), self.first.map(close))
    }

    fn samples(&self, tick: &Moment<V>) -> Samples<V> {
        let period = self.scene.period();
        let time = self.ticks as f64 * period;
        let [position, velocity] = tick.masses.device;
        let over_period = |change: V| change.map(|axis| axis / period);
        let of = |position: V, velocity: V, before: Option<V>| Motion {
            time,
            position,
            velocity,
            acceleration: before.map_or_else(V::zero, |before| over_period(velocity - before)),
        };
        let last = self.last.map_or(*tick, |(last, _)| last);
        let before = |of: fn(&Samples<V>) -> V| self.last.map(|(_, samples)| of(&samples));
        let (counted, truly) = match self.scene.velocity {
            Velocity::Exact => (velocity, velocity),
            Velocity::BackwardDifference => (
                over_period(tick.measured - last.measured),
                over_period(position - last.masses.device[0]),
            ),
        };
        Samples {
            filtered: of(tick.measured, tick.estimated, before(|it| it.filtered.velocity)),
            counted: of(tick.measured, counted, before(|it| it.counted.velocity)),
            truly: of(position, truly, before(|it| it.truly.velocity)),
        }
    }

    /// The balance of one tick, without its rest.
    fn moved(
        &mut self,
        last: &Moment<V>,
        before: &Samples<V>,
        now: &Moment<V>,
        after: &Samples<V>,
    ) -> Balance {
        let (index, span) = (self.ticks - 1, (self.span)());
        let passed = self.body.pass((index, span), last.masses, now.masses, last.acting);
        let Passed { hand, push, burnt: [device, operator, link], gained, stored } = passed;
        self.moved += stored;
        let way = now.masses.device[0] - last.masses.device[0];
        let Split { late, environment: clipped, controller } = last.split;
        let law = |motion: Motion<V>| self.law.force(motion);
        let [filtered, counted, truly] =
            [law(before.filtered), law(before.counted), law(before.truly)];
        let real = |tick: &Moment<V>, time: f64| {
            let [position, velocity] = tick.masses.device;
            Motion { time, position, velocity, acceleration: V::zero() }
        };
        let (from, to) = (real(last, before.truly.time), real(now, after.truly.time));
        let wall = self.law.work(from, to, span);
        let slow = (last.environment - filtered).inner(way);
        // Without a filter the estimates differ by rounding, which belongs to the rest, whatever that is called.
        let has_filter = self.scene.effects.filter.is_some();
        Balance {
            gained,
            hand,
            push,
            device,
            operator,
            link,
            wall,
            controller: controller.inner(way),
            saturation: -(clipped - late).inner(way),
            delay: -(late - last.environment).inner(way),
            filter: if has_filter { -(filtered - counted).inner(way) } else { 0.0 },
            encoder: -(counted - truly).inner(way),
            hold: -slow - (truly.inner(way) - wall),
            ..Balance::default()
        }
    }
}

/// The time that the plant of `scene` moves on each tick, in the scalar `T`: of jitter the numbers that the plant drew.
fn spans<T: Scalar>(scene: &Scene) -> Box<dyn FnMut() -> f64> {
    let period = scene.period();
    let Some(jitter) = scene.effects.jitter else { return Box::new(move || period) };
    let mut random = Random::new(|_| jitter.seed.get(), Source::Jitter);
    let (period, deviation) = (T::of(period), T::of(jitter.deviation.get()));
    Box::new(move || (period + deviation * random.normal::<T>()).larger(T::of(0.0)).lane(0))
}

/// Adds a tick that ends at `time`.
fn book(sum: &mut Balance, tick: &Balance, time: f64) {
    sum.to_s = time;
    let pairs = [
        (&mut sum.gained, tick.gained),
        (&mut sum.hand, tick.hand),
        (&mut sum.push, tick.push),
        (&mut sum.hold, tick.hold),
        (&mut sum.delay, tick.delay),
        (&mut sum.filter, tick.filter),
        (&mut sum.encoder, tick.encoder),
        (&mut sum.saturation, tick.saturation),
        (&mut sum.device, tick.device),
        (&mut sum.operator, tick.operator),
        (&mut sum.link, tick.link),
        (&mut sum.wall, tick.wall),
        (&mut sum.controller, tick.controller),
    ];
    for (total, part) in pairs {
        *total += part;
    }
}
