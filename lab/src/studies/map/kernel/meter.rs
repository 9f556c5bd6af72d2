//! Meters of the kernel's rollouts.

use lyapunov::environments::{ForceLaw, Kinematics, Wall};
use lyapunov::{Mask, OnePort, ParameterError, PortSample, Scalar, Stabilizer};

use super::backward::Fuse;
use super::parts::{Lanes, Watched};
use crate::files::scene::Draft;
use crate::measure::{
    Chatter, Energies, Fate, ForceFelt, Given, Settling, StiffnessFelt, Verdict, Yardstick,
    device_damper,
};
use crate::simulate::Criterion;
use crate::studies::map::outcome::Measures;

/// Meter of a rollout; each type measures no more than is asked for.
pub(super) trait Meter<T: Fuse> {
    /// Result of a lane.
    type Reading: Copy + Send;

    fn new(lanes: Lanes<'_>) -> Result<Self, ParameterError>
    where
        Self: Sized;

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

    fn new(lanes: Lanes<'_>) -> Result<Self, ParameterError> {
        let (fate, accepted) = (Fate::of_lanes(lanes.0), Mask::of(true));
        Ok(Self { fate, lanes: lanes.0.len(), accepted })
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
pub(super) struct Everything<T: Scalar> {
    rate: f64,
    ticks: f64,
    peak: T,
    active: T,
    settling: Settling<T>,
    energies: Energies<T>,
    given: Given<T>,
    wall: Wall<T>,
    surface: T,
    stiffness: T,
    force_felt: ForceFelt<T>,
    stiffness_felt: StiffnessFelt<T>,
    chatter: Option<Chatter<T>>,
}

impl<T: Fuse> Meter<T> for Everything<T> {
    type Reading = Measures;

    fn new(lanes: Lanes<'_>) -> Result<Self, ParameterError> {
        let common = lanes.common();
        let rest = |scene: &Draft| Criterion::of(scene).rest();
        Ok(Self {
            rate: common.servo_rate.get(),
            ticks: (common.ticks() + 1) as f64,
            peak: T::zero(),
            active: T::zero(),
            settling: Settling::new(lanes.each(|it| rest(it).0), lanes.each(|it| rest(it).1)),
            energies: Energies::new(),
            given: Given::new(lanes.each(device_damper)),
            wall: lanes.wall()?,
            surface: lanes.of_wall(|wall| wall.position.get()),
            stiffness: lanes.of_wall(|wall| wall.stiffness.get()),
            force_felt: ForceFelt::new(),
            stiffness_felt: StiffnessFelt::new(common.servo_rate.get()),
            chatter: Chatter::new(common.servo_rate.get()),
        })
    }

    #[inline(always)]
    fn add<S: Stabilizer<T>>(&mut self, sample: &PortSample<T>, applied: T, port: &Watched<T, S>) {
        let environment = port.port().port().effort();
        let injects = port.correction().alpha.above(T::zero());
        self.peak = applied.magnitude().larger(self.peak);
        self.active += T::choose(injects, T::one(), T::zero());
        self.settling.add(sample.position);
        self.energies.add(sample.position, environment, applied - environment);
        self.given.add(sample.work, sample.displacement);
        let ideal = self.wall.force(&Kinematics::at(sample.position, sample.velocity));
        self.force_felt.add(applied, ideal);
        self.stiffness_felt.add(applied, environment, sample.position - self.surface);
        if let Some(chatter) = &mut self.chatter {
            chatter.add(applied);
        }
    }

    fn is_decided(&self) -> bool {
        false
    }

    fn read(&self, lane: usize, _sound: bool) -> Measures {
        let chatter = self.chatter.as_ref().and_then(Chatter::root_mean_square);
        let millijoules = |energy: T| Some(1e3 * energy.lane(lane));
        let asked = self.stiffness.lane(lane);
        Measures {
            peak_force: Some(self.peak.lane(lane)),
            settling_time: self.settling.since(lane).map(|tick| tick / self.rate),
            energy_injected: millijoules(self.energies.injected()),
            energy_taken: millijoules(self.energies.taken()),
            active: Some(100.0 * self.active.lane(lane) / self.ticks),
            chatter: chatter.map(|chatter| chatter.lane(lane)),
            energy_given: millijoules(self.given.by_port()),
            energy_given_beyond_damper: millijoules(self.given.beyond_damper()),
            force_felt: self.force_felt.percent(lane),
            stiffness_felt: self.stiffness_felt.stiffness(lane).map(|felt| 100.0 * felt / asked),
        }
        .in_range()
    }
}
