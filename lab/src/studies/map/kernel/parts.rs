//! Parts of a loop whose numbers differ from lane to lane.

use lyapunov::{
    Dissipation, Held, Lolc, LyapunovCandidate, ParameterError, PortEnergy, PortSample, Scalar,
    Stabilizer,
    bodies::{Body, Impedance},
    candidates::InContact,
    environments::Wall,
    stabilizers::{Account, Member, NoStabilizer},
};

use super::backward::Fuse;
use super::port::StabilizedWall;
use super::sure::{Account as Sure, MODERATE, PERIODS};
use crate::files::scene::{self, Damping, Draft};

/// Scenes of the lanes, alike in rates and duration; lanes beyond the last scene repeat it.
#[derive(Clone, Copy, Debug)]
pub(super) struct LaneScenes<'a>(pub(super) &'a [Draft]);

impl<'a> LaneScenes<'a> {
    /// A scene for the numbers that all scenes have in common.
    pub(super) fn common(self) -> &'a Draft {
        &self.0[0]
    }

    /// One number of each scene, lane by lane.
    pub(super) fn each<T: Scalar>(self, number: impl Fn(&Draft) -> f64) -> T {
        T::from_lanes(|lane| number(self.of(lane)))
    }

    fn of(self, lane: usize) -> &'a Draft {
        &self.0[lane.min(self.0.len() - 1)]
    }

    /// Body with the numbers of each lane, reused from `last` where that has the same parts.
    pub(super) fn body<T: Scalar>(self, last: &mut Bodies<T>) -> Result<Body<T>, ParameterError> {
        let parts = Impedance {
            mass: self.each(Draft::port_mass),
            damping: self.each(|it| it.operator.damping.get() + it.device.damping.get()),
            stiffness: self.each(|it| it.operator.stiffness.get()),
        };
        let body = last.of(parts, T::of(self.common().period()))?;
        let (position, velocity) =
            (self.each(|it| it.initial.position.get()), self.each(|it| it.initial.velocity.get()));
        Ok(body.resting_at(self.each(|it| it.operator.rest.get())).starting(position, velocity))
    }

    /// Wall with the numbers of each lane.
    pub(super) fn wall<T: Scalar>(self) -> Result<Wall<T>, ParameterError> {
        let wall =
            Wall::new(self.of_wall(|it| it.stiffness.get()), self.of_wall(|it| it.damping.get()))?;
        Ok(wall.at(self.of_wall(|it| it.position.get())))
    }

    /// One number of the wall of each scene.
    pub(super) fn of_wall<T: Scalar>(self, number: fn(&scene::Wall) -> f64) -> T {
        self.each(|scene| scene.environment.wall().map_or(0.0, number))
    }

    /// Port with the numbers of each lane.
    pub(super) fn port<T: Fuse, S: Laned<T>>(self) -> Result<StabilizedWall<T, S>, ParameterError> {
        let wall = self.wall()?;
        let (ticks, period) = (self.common().environment_ratio(), self.common().period());
        let surface = self.of_wall(|wall| wall.position.get());
        let port = StabilizedWall::new(wall, ticks, S::of(self, &wall)?, period);
        Ok(if self.are_moderate() { port.sure(surface) } else { port })
    }

    /// Whether all numbers of the wall are moderate.
    fn are_moderate(self) -> bool {
        let is_moderate = |scene: &Draft| {
            let wall = scene.environment.wall();
            let wall = wall.map_or([0.0; 3], |wall| {
                [wall.stiffness.get(), wall.damping.get(), wall.position.get()]
            });
            wall.into_iter().all(|number| number.abs() <= MODERATE)
        };
        PERIODS.contains(&self.common().period()) && self.0.iter().all(is_moderate)
    }
}

/// The last body: its exact motion is computed once, not for each group of cells.
#[derive(Clone, Debug)]
pub(super) struct Bodies<T: Scalar>(Option<(Impedance<T>, T, Body<T>)>);

impl<T: Scalar> Bodies<T> {
    pub(super) fn none() -> Self {
        Self(None)
    }

    /// The body that moves so over each `period`.
    pub(super) fn of(&mut self, parts: Impedance<T>, period: T) -> Result<Body<T>, ParameterError> {
        match &self.0 {
            Some((made_of, over, body)) if *made_of == parts && *over == period => Ok(*body),
            _ => {
                let body = Body::new(parts, period)?;
                self.0 = Some((parts, period, body));
                Ok(body)
            }
        }
    }
}

/// A stabilizer with the numbers of each lane.
pub(super) trait Laned<T: Scalar>: Accounted<T> {
    fn of(lanes: LaneScenes<'_>, wall: &Wall<T>) -> Result<Self, ParameterError>;

    /// The same with the account of some `lanes` cleared.
    fn cleared(self, lanes: T::Mask) -> Self;
}

/// A stabilizer whose account can go on without it.
pub(super) trait Accounted<T: Scalar>: Stabilizer<T> + Copy {
    /// Its candidate.
    type Candidate: Crediting<T>;

    /// The account that it takes along for ticks without checks; none if it has no such ticks.
    fn account(&self) -> Option<Sure<T, Self::Candidate>>;

    /// The same with an observed energy, J.
    fn observing(self, energy: T) -> Self;
}

impl<T: Scalar> Laned<T> for NoStabilizer {
    fn of(_lanes: LaneScenes<'_>, _wall: &Wall<T>) -> Result<Self, ParameterError> {
        Ok(Self)
    }

    fn cleared(self, _lanes: T::Mask) -> Self {
        self
    }
}

macro_rules! checked {
    ($($stabilizer:ty),+) => {$(
        impl<T: Scalar> Accounted<T> for $stabilizer {
            type Candidate = PortEnergy;

            #[inline(always)]
            fn account(&self) -> Option<Sure<T, PortEnergy>> {
                None
            }

            #[inline(always)]
            fn observing(self, _energy: T) -> Self {
                self
            }
        }
    )+};
}

// What has no account, and what has one that only its own step can keep.
checked!(NoStabilizer, Member<T, (PortEnergy, Dissipation<T>)>);

impl<T: Scalar, C: Crediting<T>> Laned<T> for Lolc<T, C, Held> {
    fn of(lanes: LaneScenes<'_>, wall: &Wall<T>) -> Result<Self, ParameterError> {
        let damping = |scene: &Draft| scene.damping(scene.damping_cap());
        let limit = Damping::limit_of_lanes(&|lane| damping(lanes.of(lane)))?;
        Ok(Self::new(C::of(lanes, wall)?, limit))
    }

    fn cleared(self, lanes: T::Mask) -> Self {
        self.observing(T::choose(lanes, T::zero(), self.observed_energy()))
    }
}

impl<T: Scalar, C: Crediting<T>> Accounted<T> for Lolc<T, C, Held> {
    type Candidate = C;

    #[inline(always)]
    fn account(&self) -> Option<Sure<T, C>> {
        let (energy, most) = (self.observed_energy(), self.limit().most());
        Some(Sure { energy, most, candidate: *self.candidate() })
    }

    #[inline(never)]
    fn observing(self, energy: T) -> Self {
        let mut other = self;
        other.reset();
        let given = other.grant(energy.larger(T::zero()));
        let owed = other.owe((-energy).larger(T::zero()));
        // Lanes that are out of range have no account to keep.
        if given.is_ok() && owed.is_ok() { other } else { self }
    }
}

/// A candidate with the numbers of each lane.
pub(super) trait Crediting<T: Scalar>: LyapunovCandidate<T> + Copy {
    fn of(lanes: LaneScenes<'_>, wall: &Wall<T>) -> Result<Self, ParameterError>;

    /// The damping that it credits, N·s/m.
    fn damping(&self) -> T;

    /// Its decrease on a moderate sample: `square` is `v² T`, and the wall begins at `surface`.
    fn sure_decrease(&self, sample: &PortSample<T>, square: T, surface: T) -> T;
}

impl<T: Scalar> Crediting<T> for PortEnergy {
    fn of(_lanes: LaneScenes<'_>, _wall: &Wall<T>) -> Result<Self, ParameterError> {
        Ok(Self)
    }

    #[inline(always)]
    fn damping(&self) -> T {
        T::zero()
    }

    #[inline(always)]
    fn sure_decrease(&self, sample: &PortSample<T>, _square: T, _surface: T) -> T {
        sample.work
    }
}

impl<T: Scalar> Crediting<T> for (PortEnergy, Dissipation<T>) {
    fn of(lanes: LaneScenes<'_>, _wall: &Wall<T>) -> Result<Self, ParameterError> {
        Ok((PortEnergy, Dissipation::of(lanes.each(|scene| scene.device.damping.get()))?))
    }

    #[inline(always)]
    fn damping(&self) -> T {
        self.1.damping()
    }

    #[inline(always)]
    fn sure_decrease(&self, sample: &PortSample<T>, square: T, _surface: T) -> T {
        sample.work + self.damping() * square
    }
}

impl<T: Scalar> Crediting<T> for (PortEnergy, Dissipation<T, InContact<T>>) {
    fn of(_lanes: LaneScenes<'_>, wall: &Wall<T>) -> Result<Self, ParameterError> {
        Ok((PortEnergy, wall.dissipation()))
    }

    #[inline(always)]
    fn damping(&self) -> T {
        self.1.damping()
    }

    #[inline(always)]
    fn sure_decrease(&self, sample: &PortSample<T>, square: T, surface: T) -> T {
        let burnt = self.damping() * square;
        sample.work + T::choose(sample.position.above(surface), burnt, T::zero())
    }
}
