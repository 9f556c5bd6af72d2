//! Meters of the kernel's rollouts.

use lyapunov::environments::{ForceLaw, Kinematics, Wall};
use lyapunov::{Correction, Mask, ParameterError, PortSample, Scalar};

use super::backward::Fuse;
use super::parts::LaneScenes;
use crate::files::scene::Draft;
use crate::measure::runs::{Instant, Measures, Meter as _, Meters, Ran};
use crate::measure::{Fate, Verdict, Watched, Yardstick, device_damper};
use crate::simulate::Criterion;

/// Meter of a rollout; each type measures no more than is asked for.
pub(super) trait Meter<T: Fuse>: Sized {
    /// Result of a lane.
    type Reading: Copy + Send;

    /// What changes from tick to tick.
    type Watch<'a>: Watch<T>
    where
        Self: 'a;

    fn new(lanes: LaneScenes<'_>) -> Result<Self, ParameterError>;

    /// The ticks that one watch may take from here on, at least one.
    fn room(&mut self) -> u64;

    /// Takes apart, for some ticks, what changes from one to the next, so that it may stay in registers.
    fn watch(&mut self) -> Self::Watch<'_>;

    /// Whether later ticks cannot change the result.
    fn is_decided(&mut self) -> bool;

    /// Whether it needs no more than positions, so that ticks may go [without checks](super::sure).
    fn needs_positions_only(&self) -> bool;

    /// The lanes that left the range of the scalar, or that of bounded runs by far, whose later ticks do not matter; none if there
    /// is none.
    fn out_of_range(&self, position: T) -> Option<T::Mask>;

    /// Result of a lane; `sound`: its last row is finite.
    fn read(&self, lane: usize, sound: bool) -> Self::Reading;
}

/// What a meter changes from tick to tick.
pub(super) trait Watch<T: Scalar> {
    /// Adds one tick: the motion, the wall's force, and its correction, applied from here on.
    fn add(&mut self, sample: &PortSample<T>, wall: T, correction: &Correction<T>);

    /// Adds the position of one tick of moderate numbers, all that a meter of [positions](Meter::needs_positions_only) needs.
    fn place(&mut self, position: T);

    /// The largest |position| so far or more, a NaN aside.
    fn reach(&self) -> T;

    /// Ends after as many `ticks`.
    fn end(self, ticks: u64);
}

/// The distance from which on the lanes are looked at that may have left their bound, m.
const FAR: f64 = 1.0;

/// Meter of the verdict alone.
pub(super) struct Verdicts<T: Scalar> {
    fate: Fate<T>,
    lanes: usize,
    /// The lanes before this one are lost.
    lost: usize,
    accepted: T::Mask,
}

/// Verdicts along some ticks.
pub(super) struct WatchedVerdicts<'a, T: Scalar> {
    fate: Watched<'a, T>,
    accepted: T::Mask,
    all: &'a mut T::Mask,
}

impl<T: Scalar> Watch<T> for WatchedVerdicts<'_, T> {
    #[inline(always)]
    fn add(&mut self, sample: &PortSample<T>, _wall: T, correction: &Correction<T>) {
        self.fate.add(sample.position, sample.velocity);
        self.accepted = self.accepted & correction.accepted;
    }

    #[inline(always)]
    fn place(&mut self, position: T) {
        self.fate.place(position);
    }

    #[inline(always)]
    fn reach(&self) -> T {
        self.fate.reach()
    }

    #[inline(always)]
    fn end(self, ticks: u64) {
        self.fate.end(ticks);
        *self.all = self.accepted;
    }
}

impl<T: Fuse> Meter<T> for Verdicts<T> {
    type Reading = (Verdict, Yardstick);

    type Watch<'a> = WatchedVerdicts<'a, T>;

    fn new(lanes: LaneScenes<'_>) -> Result<Self, ParameterError> {
        let (fate, accepted) = (Fate::of_lanes(lanes.0), Mask::of(true));
        Ok(Self { fate, lanes: lanes.0.len(), lost: 0, accepted })
    }

    fn room(&mut self) -> u64 {
        self.fate.room()
    }

    #[inline(always)]
    fn watch(&mut self) -> WatchedVerdicts<'_, T> {
        let Self { fate, accepted, .. } = self;
        WatchedVerdicts { fate: fate.watched(), accepted: *accepted, all: accepted }
    }

    fn is_decided(&mut self) -> bool {
        while self.lost < self.lanes && self.fate.is_lost(self.lost) {
            self.lost += 1;
        }
        self.lost == self.lanes
    }

    fn needs_positions_only(&self) -> bool {
        self.fate.needs_positions_only()
    }

    #[inline(always)]
    fn out_of_range(&self, position: T) -> Option<T::Mask> {
        let near = position.magnitude().below(T::of(FAR));
        if (near & self.accepted).all() {
            return None;
        }
        let is_out =
            |lane| f64::from(lane < self.lanes && !near.lane(lane) && self.fate.is_out(lane));
        let out = !self.accepted | T::from_lanes(is_out).above(T::zero());
        out.any().then_some(out)
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

impl<T: Scalar> Watch<T> for &mut Everything<T> {
    #[inline(always)]
    fn add(&mut self, sample: &PortSample<T>, wall: T, correction: &Correction<T>) {
        let applied = correction.effort;
        let (depth, magnitude) = (sample.position - self.surface, applied.magnitude());
        self.meters.add(&Instant {
            position: sample.position,
            coordinate: sample.position,
            moved: sample.displacement,
            work: sample.work,
            applied,
            environment: wall,
            controller: applied - wall,
            magnitudes: [magnitude, wall.magnitude()],
            alpha: correction.alpha,
            ideal: self.wall.force(&Kinematics::at(sample.position, sample.velocity)),
            pressed: [depth, applied],
        });
    }

    fn place(&mut self, _position: T) {}

    fn reach(&self) -> T {
        T::largest()
    }

    fn end(self, _ticks: u64) {}
}

impl<T: Fuse> Meter<T> for Everything<T> {
    type Reading = Measures;

    type Watch<'a>
        = &'a mut Self
    where
        T: 'a;

    fn new(lanes: LaneScenes<'_>) -> Result<Self, ParameterError> {
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

    fn room(&mut self) -> u64 {
        u64::MAX
    }

    #[inline(always)]
    fn watch(&mut self) -> &mut Self {
        self
    }

    fn is_decided(&mut self) -> bool {
        false
    }

    fn needs_positions_only(&self) -> bool {
        false
    }

    fn out_of_range(&self, _position: T) -> Option<T::Mask> {
        None
    }

    fn read(&self, lane: usize, _sound: bool) -> Measures {
        let stiffness = Some(self.stiffness.lane(lane));
        self.meters.read(lane, Ran { rate: self.rate, ticks: self.ticks, stiffness })
    }
}
