//! Meters of the kernel's rollouts.

use lyapunov::{Mask, OnePort, PortSample, Scalar, Stabilizer};

use super::backward::Fuse;
use super::parts::{Lanes, Watched};
use crate::files::scene::Draft;
use crate::measure::{Chatter, Energies, Fate, Settling, Verdict, Yardstick};
use crate::simulate::Criterion;
use crate::studies::map::outcome::Measures;

/// Meter of a rollout; each type measures no more than is asked for.
pub(super) trait Meter<T: Fuse> {
    /// Result of a lane.
    type Reading: Copy + Send;

    fn new(lanes: Lanes<'_>) -> Self;

    /// Adds one tick: the motion, and `applied`, the force from here on.
    fn add<S: Stabilizer<T>>(&mut self, sample: &PortSample<T>, applied: T, port: &Watched<T, S>);

    /// Whether later ticks cannot change the result.
    fn is_decided(&self) -> bool;

    /// Result of a lane; `sound`: its last row is finite.
    fn read(&self, lane: usize, sound: bool) -> Self::Reading;
}

/// Meter of the verdict alone.
pub(super) struct Verdicts<T: Scalar> {
    fate: Fate<T>,
    lanes: usize,
    accepted: T::Mask,
}

impl<T: Fuse> Meter<T> for Verdicts<T> {
    type Reading = (Verdict, Yardstick);

    fn new(lanes: Lanes<'_>) -> Self {
        Self { fate: Fate::of_lanes(lanes.0), lanes: lanes.0.len(), accepted: Mask::of(true) }
    }

    #[inline(always)]
    fn add<S: Stabilizer<T>>(&mut self, sample: &PortSample<T>, _applied: T, port: &Watched<T, S>) {
        self.fate.add(sample.position, sample.velocity);
        self.accepted = self.accepted & port.correction().accepted;
    }

    fn is_decided(&self) -> bool {
        (0..self.lanes).all(|lane| self.fate.is_lost(lane))
    }

    fn read(&self, lane: usize, sound: bool) -> (Verdict, Yardstick) {
        let in_range = sound && self.accepted.lane(lane);
        let verdict = if in_range { self.fate.verdict(lane) } else { Verdict::Grows };
        (verdict, self.fate.verdict_by(lane))
    }
}

/// Meter of all measures of a run that does not grow.
pub(super) struct Everything<T> {
    rate: f64,
    ticks: f64,
    peak: T,
    active: T,
    settling: Settling<T>,
    energies: Energies<T>,
    chatter: Option<Chatter<T>>,
}

impl<T: Fuse> Meter<T> for Everything<T> {
    type Reading = Measures;

    fn new(lanes: Lanes<'_>) -> Self {
        let common = lanes.common();
        let rest = |scene: &Draft| Criterion::of(scene).rest();
        Self {
            rate: common.servo_rate.get(),
            ticks: (common.ticks() + 1) as f64,
            peak: T::zero(),
            active: T::zero(),
            settling: Settling::new(lanes.each(|it| rest(it).0), lanes.each(|it| rest(it).1)),
            energies: Energies::new(),
            chatter: Chatter::new(common.servo_rate.get()),
        }
    }

    #[inline(always)]
    fn add<S: Stabilizer<T>>(&mut self, sample: &PortSample<T>, applied: T, port: &Watched<T, S>) {
        let environment = port.port().port().effort();
        let injects = port.correction().alpha.above(T::zero());
        self.peak = applied.magnitude().larger(self.peak);
        self.active += T::choose(injects, T::one(), T::zero());
        self.settling.add(sample.position);
        self.energies.add(sample.position, environment, applied - environment);
        if let Some(chatter) = &mut self.chatter {
            chatter.add(applied);
        }
    }

    fn is_decided(&self) -> bool {
        false
    }

    fn read(&self, lane: usize, _sound: bool) -> Measures {
        let chatter = self.chatter.as_ref().and_then(Chatter::root_mean_square);
        Measures {
            peak_force: Some(self.peak.lane(lane)),
            settling_time: self.settling.since(lane).map(|tick| tick / self.rate),
            energy_injected: Some(1e3 * self.energies.injected().lane(lane)),
            energy_taken: Some(1e3 * self.energies.taken().lane(lane)),
            active: Some(100.0 * self.active.lane(lane) / self.ticks),
            chatter: chatter.map(|chatter| chatter.lane(lane)),
        }
        .in_range()
    }
}
