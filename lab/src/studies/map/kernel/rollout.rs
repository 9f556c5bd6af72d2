//! The loop over the ticks of rollouts on lanes.

use lyapunov::{Mask, OnePort, ParameterError, Plant, PortSample, bodies::Body};
use pulp::NullaryFnOnce;

use super::backward::Fuse;
use super::meter::Meter;
use super::parts::{Bodies, Laned, Watched};
use super::seats::Seats;

/// Groups that run side by side: one computes while another waits for a quotient.
const BESIDE: usize = 4;

/// Ticks between two checks whether groups are decided.
const STRETCH: u64 = 64;

/// Rollouts of some cells, one lane each, measured by an `M`; a decided group of lanes makes room for the next.
///
/// Every function between here and the arithmetic is always inlined: a function that is called instead is compiled for
/// the base set of instructions, whatever this is compiled for.
pub(super) struct Rollouts<'a, T: Fuse, S, M: Meter<T>> {
    seats: Seats<'a>,
    readings: Vec<M::Reading>,
    bodies: Bodies<T>,
    fuses: bool,
    go_on: &'a (dyn Fn() -> bool + Sync),
    ports: std::marker::PhantomData<S>,
}

/// A running group of lanes.
struct Group<T: Fuse, S, M> {
    plant: Body<T>,
    port: Watched<T, S>,
    sample: PortSample<T>,
    meter: M,
    /// The remaining ticks.
    left: u64,
    first: usize,
    count: usize,
}

impl<T: Fuse, S: Laned<T>, M: Meter<T>> Group<T, S, M> {
    #[inline(always)]
    fn tick(&mut self) {
        let effort = self.port.respond(&self.sample);
        self.meter.add(&self.sample, effort, &self.port);
        // The period stays, and a whole sample would be built elsewhere and copied here.
        let next = self.plant.advance(effort);
        self.sample.position = next.position;
        self.sample.velocity = next.velocity;
        self.sample.displacement = next.displacement;
        self.sample.applied = next.applied;
        self.sample.work = next.work;
    }

    /// Runs the last tick, after which nothing moves. Returns the lanes whose row is finite.
    ///
    /// It runs once and need not be fast.
    #[inline(never)]
    fn finish(&mut self) -> T::Mask {
        let effort = self.port.respond(&self.sample);
        self.meter.add(&self.sample, effort, &self.port);
        self.sample.position.finite() & self.sample.velocity.finite() & effort.finite()
    }
}

impl<'a, T: Fuse, S: Laned<T>, M: Meter<T>> Rollouts<'a, T, S, M> {
    pub(super) fn new(
        seats: Seats<'a>,
        empty: M::Reading,
        fuses: bool,
        go_on: &'a (dyn Fn() -> bool + Sync),
    ) -> Self {
        let readings = vec![empty; seats.len()];
        let (bodies, ports) = (Bodies::none(), std::marker::PhantomData);
        Self { seats, readings, bodies, fuses, go_on, ports }
    }

    #[inline(never)]
    fn next(&mut self) -> Result<Option<Group<T, S, M>>, ParameterError> {
        let Some((first, lanes)) = self.seats.next(T::LANES) else { return Ok(None) };
        let (count, left) = (lanes.0.len(), lanes.common().ticks() + 1);
        let (meter, plant) = (M::new(lanes)?, lanes.body(&mut self.bodies)?);
        let port = lanes.port(self.fuses)?;
        let sample = plant.start();
        Ok(Some(Group { plant, port, sample, meter, left, first, count }))
    }

    #[inline(never)]
    fn put(&mut self, group: &Group<T, S, M>, sound: T::Mask) {
        for lane in 0..group.count {
            self.readings[group.first + lane] = group.meter.read(lane, sound.lane(lane));
        }
    }

    /// Whether the group is done; if so, stores its readings.
    #[inline(always)]
    fn settle(&mut self, group: &mut Group<T, S, M>) -> bool {
        let is_last = group.left == 1;
        if !is_last && !group.meter.is_decided() {
            return false;
        }
        let sound = if is_last { group.finish() } else { Mask::of(true) };
        self.put(group, sound);
        true
    }
}

impl<T: Fuse, S: Laned<T>, M: Meter<T>> NullaryFnOnce for Rollouts<'_, T, S, M> {
    type Output = Result<Option<Vec<M::Reading>>, ParameterError>;

    #[inline(always)]
    fn call(mut self) -> Self::Output {
        // With one lane there is one rollout at a time: the reference for the speed of the lanes.
        let beside = if T::LANES == 1 { 1 } else { BESIDE };
        let mut groups = Vec::with_capacity(beside);
        loop {
            while groups.len() < beside {
                match self.next()? {
                    Some(group) => groups.push(group),
                    None => break,
                }
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
            let ticks = groups.iter().map(|group| group.left - 1).min().unwrap_or_default();
            let stretch = ticks.min(STRETCH);
            for _ in 0..stretch {
                for group in &mut groups {
                    group.tick();
                }
            }
            for group in &mut groups {
                group.left -= stretch;
            }
        }
    }
}
