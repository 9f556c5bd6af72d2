//! The loop over the ticks of rollouts on lanes.

use lyapunov::{Mask, ParameterError, Plant, PortSample, Stabilizer, bodies::Body};
use pulp::NullaryFnOnce;

use super::Readings;
use super::batch::Batch;
use super::meter::{Meter, Watch};
use super::parts::{Accounted, Bodies, Crediting, Laned};
use super::port::StabilizedWall;
use super::seats::Seats;
use super::sure::{Asked, SurePort};
use crate::measure::GoOn;

/// Ticks between two checks whether groups are decided.
pub(super) const STRETCH: u64 = 64;

/// The number of times that ticks of a group may be thrown away because they needed checks.
const TRIES: u8 = 4;

/// Rollouts of some cells, one lane each, measured by an `M`; a decided group of lanes makes room for the next.
///
/// Every function between here and the arithmetic is always inlined: a function that is called instead is compiled for
/// the base set of instructions, whatever this is compiled for.
pub(super) struct Rollouts<'a, T: Batch, S, M: Meter<T>> {
    seats: Seats<'a>,
    readings: Vec<M::Reading>,
    bodies: Bodies<T>,
    go_on: &'a GoOn<'a>,
    ports: std::marker::PhantomData<S>,
}

/// The loop of a group of lanes.
#[derive(Clone, Copy)]
pub(super) struct Loop<T: Batch, S> {
    pub(super) plant: Body<T>,
    pub(super) port: StabilizedWall<T, S>,
    pub(super) sample: PortSample<T>,
    /// The number of times more that ticks without checks may turn out to need them.
    pub(super) tries: u8,
}

impl<T: Batch, S: Stabilizer<T>> Loop<T, S> {
    /// `plant` from its start on, at `port`.
    pub(super) fn new(plant: Body<T>, port: StabilizedWall<T, S>) -> Self {
        Self { plant, port, sample: plant.start(), tries: TRIES }
    }

    #[inline(always)]
    fn tick(&mut self, watch: &mut impl Watch<T>) {
        let correction = self.port.respond(&self.sample);
        watch.add(&self.sample, self.port.answer(), &correction);
        advance_by(correction.effort, &mut self.plant, &mut self.sample);
    }
}

impl<T: Batch, S: Accounted<T>> Loop<T, S> {
    /// Runs some ticks in registers.
    #[inline(always)]
    fn run(&mut self, ticks: u64, mut watch: impl Watch<T>) {
        self.port.catch_up();
        let mut own = *self;
        for _ in 0..ticks {
            own.tick(&mut watch);
        }
        watch.end(ticks);
        *self = own;
    }

    /// Runs some ticks [without checks](super::sure) and tells whether they needed none; else nothing has happened.
    #[inline(always)]
    fn leap(&mut self, ticks: u64, watch: impl Watch<T>) -> bool {
        let Some(mut leap) = self.begin(watch) else { return false };
        for _ in 0..ticks {
            let asked = leap.ask();
            leap.reply(asked);
        }
        self.end(leap, ticks)
    }

    /// The same of two loops, one half a tick ahead of the other: each moves while the other waits for a quotient. None where one of
    /// them has no such ticks.
    #[inline(always)]
    fn leap_both<W: Watch<T>>(both: [(&mut Self, W); 2], ticks: u64) -> Option<[bool; 2]> {
        let [(first_loop, first_watch), (second_loop, second_watch)] = both;
        let leaps = (first_loop.begin(first_watch), second_loop.begin(second_watch));
        let (mut first, mut second) = (leaps.0?, leaps.1?);
        let mut ahead = first.ask();
        for _ in 1..ticks {
            let behind = second.ask();
            first.reply(ahead);
            ahead = first.ask();
            second.reply(behind);
        }
        let behind = second.ask();
        first.reply(ahead);
        second.reply(behind);
        Some([first_loop.end(first, ticks), second_loop.end(second, ticks)])
    }

    #[inline(always)]
    fn begin<W>(&self, watch: W) -> Option<Leap<T, S::Candidate, W>> {
        if !T::IN_REGISTERS || self.tries == 0 {
            return None;
        }
        let port = self.port.unchecked(&self.sample)?;
        Some(Leap { plant: self.plant, port, sample: self.sample, watch })
    }

    #[inline(always)]
    fn end<W: Watch<T>>(&mut self, leap: Leap<T, S::Candidate, W>, ticks: u64) -> bool {
        let Leap { plant, port, sample, watch } = leap;
        if !port.was_sure(watch.reach(), sample.position) {
            self.tries -= 1;
            return false;
        }
        watch.end(ticks);
        self.port.follow(&port);
        (self.plant, self.sample) = (plant, sample);
        true
    }
}

/// A loop during ticks [without checks](super::sure).
struct Leap<T: Batch, C, W> {
    plant: Body<T>,
    port: SurePort<T, C>,
    sample: PortSample<T>,
    watch: W,
}

impl<T: Batch, C: Crediting<T>, W: Watch<T>> Leap<T, C, W> {
    #[inline(always)]
    fn ask(&mut self) -> Asked<T> {
        self.watch.place(self.sample.position);
        self.port.ask(&self.sample)
    }

    #[inline(always)]
    fn reply(&mut self, asked: Asked<T>) {
        advance_by(self.port.reply(asked), &mut self.plant, &mut self.sample);
    }
}

/// A loop with what watches it.
pub(super) trait WatchedLoop<T: Batch, S> {
    /// The view of some ticks.
    type Watch<'a>: Watch<T>
    where
        Self: 'a;

    /// The loop, and a view of the ticks that it runs next.
    fn apart(&mut self) -> (&mut Loop<T, S>, Self::Watch<'_>);
}

/// Runs some ticks of loops side by side.
#[inline(always)]
pub(super) fn run<T: Batch, S: Accounted<T>, G: WatchedLoop<T, S>>(groups: &mut [G], ticks: u64) {
    if T::IN_REGISTERS {
        let both = match groups {
            [first, second] if T::BESIDE == 2 => {
                Loop::leap_both([first.apart(), second.apart()], ticks)
            }
            _ => None,
        };
        for (place, group) in groups.iter_mut().enumerate() {
            let has_run = match both {
                Some(both) => both[place],
                None => {
                    let (looped, watch) = group.apart();
                    looped.leap(ticks, watch)
                }
            };
            if !has_run {
                let (looped, watch) = group.apart();
                looped.run(ticks, watch);
            }
        }
    } else {
        for _ in 0..ticks {
            for group in groups.iter_mut() {
                let (looped, mut watch) = group.apart();
                looped.tick(&mut watch);
                watch.end(1);
            }
        }
    }
}

#[inline(always)]
fn advance_by<T: Batch>(effort: T, plant: &mut Body<T>, sample: &mut PortSample<T>) {
    // The period stays, and a whole sample would be built elsewhere and copied here.
    let next = plant.advance(effort);
    sample.position = next.position;
    sample.velocity = next.velocity;
    sample.displacement = next.displacement;
    sample.applied = next.applied;
    sample.work = next.work;
}

/// A running group of lanes.
struct Group<T: Batch, S, M> {
    looped: Loop<T, S>,
    meter: M,
    /// The remaining ticks.
    left: u64,
    /// The lanes whose last row is finite; all of them before it.
    sound: T::Mask,
    first: usize,
    count: usize,
}

impl<T: Batch, S: Accounted<T>, M: Meter<T>> WatchedLoop<T, S> for Group<T, S, M> {
    type Watch<'a>
        = M::Watch<'a>
    where
        Self: 'a;

    #[inline(always)]
    fn apart(&mut self) -> (&mut Loop<T, S>, M::Watch<'_>) {
        (&mut self.looped, self.meter.watch())
    }
}

impl<T: Batch, S: Laned<T>, M: Meter<T>> Group<T, S, M> {
    /// Puts lanes that left the range to rest: a stabilizer that rejects their samples takes twice as long for all lanes.
    #[inline(never)]
    fn rest(&mut self, lanes: T::Mask) {
        let Loop { plant, port, sample, .. } = &mut self.looped;
        let still = |value| T::choose(lanes, T::zero(), value);
        sample.position = still(sample.position);
        sample.velocity = still(sample.velocity);
        sample.displacement = still(sample.displacement);
        sample.applied = still(sample.applied);
        sample.work = still(sample.work);
        *plant = plant.starting(sample.position, sample.velocity);
        port.clear(lanes);
    }
}

impl<'a, T: Batch, S: Laned<T>, M: Meter<T>> Rollouts<'a, T, S, M> {
    pub(super) fn new(seats: Seats<'a>, empty: M::Reading, go_on: &'a GoOn<'a>) -> Self {
        let readings = vec![empty; seats.len()];
        let (bodies, ports) = (Bodies::none(), std::marker::PhantomData);
        Self { seats, readings, bodies, go_on, ports }
    }

    /// Adds the group of the next cells, unless there are none.
    #[inline(never)]
    fn seat(&mut self, groups: &mut Vec<Group<T, S, M>>) -> Result<(), ParameterError> {
        let Some((first, lanes)) = self.seats.next(T::LANES) else { return Ok(()) };
        let (count, left) = (lanes.0.len(), lanes.common().ticks() + 1);
        let (meter, plant) = (M::new(lanes)?, lanes.body(&mut self.bodies)?);
        let (mut looped, sound) = (Loop::new(plant, lanes.port()?), Mask::of(true));
        if !meter.needs_positions_only() {
            looped.tries = 0;
        }
        groups.push(Group { looped, meter, left, sound, first, count });
        Ok(())
    }

    #[inline(never)]
    fn put(&mut self, group: &Group<T, S, M>) {
        for lane in 0..group.count {
            self.readings[group.first + lane] = group.meter.read(lane, group.sound.lane(lane));
        }
    }

    /// Whether the group is done; if so, stores its readings.
    #[inline(always)]
    fn settle(&mut self, group: &mut Group<T, S, M>) -> bool {
        match group.left {
            0 => group.sound = group.sound & group.looped.sample.applied.finite(),
            1 => {
                let PortSample { position, velocity, .. } = group.looped.sample;
                group.sound = position.finite() & velocity.finite();
                return false;
            }
            _ if group.meter.is_decided() => {}
            _ => {
                if let Some(lanes) = group.meter.out_of_range(group.looped.sample.position) {
                    group.rest(lanes);
                }
                return false;
            }
        }
        self.put(group);
        true
    }
}

impl<T: Batch, S: Laned<T>, M: Meter<T>> NullaryFnOnce for Rollouts<'_, T, S, M> {
    type Output = Readings<M::Reading>;

    #[inline(always)]
    fn call(mut self) -> Self::Output {
        let mut groups = Vec::with_capacity(T::BESIDE);
        loop {
            for _ in groups.len()..T::BESIDE {
                self.seat(&mut groups)?;
            }
            if groups.is_empty() {
                return Ok(Some(self.readings));
            }
            if !(self.go_on)() {
                return Ok(None);
            }
            let before = groups.len();
            let mut at = 0;
            while at < groups.len() {
                if self.settle(&mut groups[at]) { drop(groups.swap_remove(at)) } else { at += 1 }
            }
            if groups.len() < before {
                continue;
            }
            advance(&mut groups);
        }
    }
}

/// Runs groups side by side until the next check.
#[inline(always)]
fn advance<T: Batch, S: Laned<T>, M: Meter<T>>(groups: &mut [Group<T, S, M>]) {
    // The last tick comes by itself: the motion before it tells whether it is sound.
    let room = |group: &mut Group<T, S, M>| group.meter.room().min((group.left - 1).max(1));
    let ticks = groups.iter_mut().map(room).min().unwrap_or_default().min(STRETCH);
    run(groups, ticks);
    for group in groups {
        group.left -= ticks;
    }
}
