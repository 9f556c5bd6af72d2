//! Meters of the kernel's rollouts.

use lyapunov::environments::{ForceLaw, Kinematics, Wall};
use lyapunov::{Mask, OnePort, ParameterError, PortSample, Scalar, Stabilizer};

use super::backward::Fuse;
use super::parts::{Lanes, Watched};
use crate::files::scene::Draft;
use crate::measure::runs::{Instant, Measures, Meter as _, Meters, Ran};
use crate::measure::{Fate, Verdict, Yardstick, device_damper};
use crate::simulate::Criterion;

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
    meters: Meters<T>,
    wall: Wall<T>,
    surface: T,
    stiffness: T,
}

impl<T: Fuse> Meter<T> for Everything<T> {
    type Reading = Measures;

    fn new(lanes: Lanes<'_>) -> Result<Self, ParameterError> {
        let common = lanes.common();
        let rate = common.servo_rate.get();
        let rest = |scene: &Draft| Criterion::of(scene).rest();
        let band = (lanes.each(|it| rest(it).0), lanes.each(|it| rest(it).1));
        Ok(Self {
            rate,
            ticks: (common.ticks() + 1) as f64,
            meters: Meters::new(rate, lanes.each(device_damper), band),
            wall: lanes.wall()?,
            surface: lanes.of_wall(|wall| wall.position.get()),
            stiffness: lanes.of_wall(|wall| wall.stiffness.get()),
        })
    }

    #[inline(always)]
    fn add<S: Stabilizer<T>>(&mut self, sample: &PortSample<T>, applied: T, port: &Watched<T, S>) {
        let environment = port.port().port().effort();
        let (depth, magnitude) = (sample.position - self.surface, applied.magnitude());
        self.meters.add(&Instant {
            position: sample.position,
            coordinate: sample.position,
            moved: sample.displacement,
            work: sample.work,
            applied,
            environment,
            controller: applied - environment,
            magnitudes: [magnitude, environment.magnitude()],
            alpha: port.correction().alpha,
            ideal: self.wall.force(&Kinematics::at(sample.position, sample.velocity)),
            pressed: [depth, applied],
        });
    }

    fn is_decided(&self) -> bool {
        false
    }

    fn read(&self, lane: usize, _sound: bool) -> Measures {
        let stiffness = Some(self.stiffness.lane(lane));
        self.meters.read(lane, Ran { rate: self.rate, ticks: self.ticks, stiffness })
    }
}
