//! Runs of scenes whose loops are built of boxes: on lanes where they are alike, and else one by one.

use lyapunov::environments::{ForceLaw, Kinematics, NearestPoint, Solid, Time};
use lyapunov::{Mask, ParameterError, Scalar, Signal};
use nalgebra::SVector;
use num_traits::Zero;
use pulp::NullaryFnOnce;

use super::alike::{groups, has_lanes};
use super::meters::{Instant, Meter, Metering, Ran};
use crate::files::scene::{Boxed, Draft, Scene, Stabilizer};
use crate::measure::fate::Fate;
use crate::measure::given::device_damper;
use crate::measure::share::Share;
use crate::measure::verdict::{Verdict, Yardstick};
use crate::measure::watch::GoOn;
use crate::simulate::{
    Criterion, F64x8, Fitted, Instructions, Rollout, Scenes, Space, Tick, in_space,
};

/// Ticks between two checks whether verdicts are decided.
const STRETCH: u64 = 64;

/// Groups of lanes that run side by side: one computes while another waits.
const BESIDE: usize = 2;

/// Runs of scenes, each under a table.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Runs<'a> {
    /// The scene of each run.
    pub(crate) scenes: &'a [Scene],
    /// The scene that the stabilizer of each run is set for, whichever loop it runs on.
    pub(crate) told: &'a [Scene],
    /// The table of each run's stabilizer.
    pub(crate) tables: &'a [Option<Stabilizer>],
    /// The instructions of lanes; none runs each scene by itself.
    pub(crate) instructions: Option<Instructions>,
}

/// Result of a run.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Judged<R> {
    /// The verdict.
    pub(crate) verdict: Verdict,
    /// The quantity that the run is judged by.
    pub(crate) verdict_by: Yardstick,
    /// What was measured; nothing of a run that grows, for that would only show how long it ran.
    pub(crate) reading: Option<R>,
}

/// A parameter out of the range of the scalar, and the place of its run.
pub(crate) type Refused = (usize, ParameterError);

/// Results of runs, at their places.
type Done<M> = [Option<Judged<<M as Metering>::Reading>>];

impl Runs<'_> {
    /// Results of the runs, measured by `M`; none if `go_on` stopped them. A lost run is not run to its end.
    ///
    /// # Errors
    /// A parameter out of the range of the scalar.
    pub(crate) fn measured<M: Metering>(
        self,
        go_on: &GoOn<'_>,
    ) -> Result<Option<Vec<Judged<M::Reading>>>, Refused> {
        let work = Work { runs: self, go_on };
        let mut done = vec![None; self.scenes.len()];
        let mut alone: Vec<Vec<usize>> = Vec::new();
        let fit = || self.scenes.iter().zip(self.tables).all(|(it, table)| has_lanes(it, table));
        match self.instructions.filter(|_| fit()) {
            None => alone.extend((0..self.scenes.len()).map(|place| vec![place])),
            Some(instructions) => {
                let groups = groups(self.scenes, self.told, self.tables, F64x8::LANES);
                let (several, single): (Vec<_>, Vec<_>) =
                    groups.into_iter().partition(|group| group.len() > 1);
                alone.extend(single);
                match work.run::<F64x8, M>(several, instructions, &mut done)? {
                    None => return Ok(None),
                    Some(refused) => alone.extend(refused),
                }
            }
        }
        // All scenes of a study have the same scalar and the same dimensions.
        let Some(scene) = self.scenes.first() else { return Ok(Some(Vec::new())) };
        let base = Instructions::Base;
        let finished = in_space!(scene, Axes => work.run::<Axes, M>(alone, base, &mut done)?);
        Ok(finished.and_then(|_| done.into_iter().collect()))
    }
}

/// Runs that can be stopped.
struct Work<'a> {
    runs: Runs<'a>,
    go_on: &'a GoOn<'a>,
}

impl Work<'_> {
    /// Runs `groups` of places and writes their results; returns those places that have to run by themselves, for one of
    /// their group has a parameter out of range, and none if it was stopped.
    fn run<T: Metered, M: Metering>(
        &self,
        groups: Vec<Vec<usize>>,
        instructions: Instructions,
        done: &mut Done<M>,
    ) -> Result<Option<Vec<Vec<usize>>>, Refused> {
        let beside = if <T::Scalar as Scalar>::LANES == 1 { 1 } else { BESIDE };
        let (mut waiting, mut refused) = (groups.into_iter(), Vec::new());
        let mut running: Vec<Group<T, M>> = Vec::with_capacity(beside);
        loop {
            while running.len() < beside {
                let Some(places) = waiting.next() else { break };
                match self.group(&places, instructions) {
                    Ok(group) => running.push(group),
                    Err(error) if places.len() == 1 => return Err((places[0], error)),
                    Err(_) => refused.extend(places.into_iter().map(|place| vec![place])),
                }
            }
            let Some(least) = running.iter().map(|group| group.left).min() else {
                return Ok(Some(refused));
            };
            if !(self.go_on)() {
                return Ok(None);
            }
            T::run(instructions, Ticks { groups: &mut running, count: least.min(STRETCH) });
            running.retain(|group| {
                let is_done = group.is_done();
                if is_done {
                    group.read(done);
                }
                !is_done
            });
        }
    }

    fn group<T: Metered, M: Metering>(
        &self,
        places: &[usize],
        instructions: Instructions,
    ) -> Result<Group<T, M>, ParameterError> {
        let at = |of: &[Scene]| -> Vec<Scene> { places.iter().map(|at| of[*at].clone()).collect() };
        let (scenes, told) = (at(self.runs.scenes), at(self.runs.told));
        let tables: Vec<_> = places.iter().map(|at| self.runs.tables[*at]).collect();
        let on = Scenes::on(&scenes, instructions);
        let fitted = Fitted::on(Scenes::on(&told, instructions), &tables)?;
        let rollout = Rollout::on(on, fitted)?;
        let fate = Fate::of_lanes(scenes.iter().map(|scene| &**scene));
        let rest = |lane: usize| fate.criterion(lane.min(scenes.len() - 1)).rest();
        let number = |of: &dyn Fn(usize) -> f64| Number::<T>::from_lanes(of);
        let band = (number(&|lane| rest(lane).0), number(&|lane| rest(lane).1));
        let limit = |it: &Scene| it.effects.saturation.map_or(f64::INFINITY, |it| it.force.get());
        // Rounded as the loop rounds it.
        let limit: T::Scalar = on.each(limit);
        let common = on.common();
        let damper = number(&|lane| device_damper(on.lane(lane)));
        let impedance = common.environment.kind().impedance();
        let is_massless = impedance.is_none_or(|it| it.mass == 0.0);
        Ok(Group {
            rollout,
            fate,
            meters: Meter::new(common.servo_rate.get(), damper, band),
            share: Share::late(common.delay_ticks() as usize, number(&|lane| limit.lane(lane))),
            law: is_massless.then(|| T::Meter::render(on, Boxed).ok()).flatten(),
            surface: T::surface(on),
            sound: Mask::of(true),
            left: common.ticks() + 1,
            places: places.to_vec(),
            scenes,
        })
    }
}

/// The scalar of the meters along loops of `T`.
type Number<T> = <<T as Metered>::Meter as Signal>::Scalar;

/// A signal of loops, and that of the meters along them.
trait Metered: Space {
    /// The same axes, no narrower than `f64`.
    type Meter: Space<Scalar: Scalar<Mask = <Self::Scalar as Scalar>::Mask>>;

    /// The surface of the environment.
    type Surface;

    fn metered(self) -> Self::Meter;

    /// The coordinate of a position that a motion is judged along.
    fn coordinate(position: Self::Meter, criterion: &Criterion) -> Number<Self>;

    /// The length, on a line the magnitude, lane by lane.
    fn magnitude(of: Self::Meter) -> Number<Self>;

    /// The surface of the environment of the scenes; none of one that is neither a wall nor a solid.
    fn surface(scenes: Scenes<'_>) -> Option<Self::Surface>;

    /// The depth of a position below the surface, and the part of a force against it.
    fn pressed(
        surface: &Self::Surface,
        position: Self::Meter,
        force: Self::Meter,
    ) -> [Number<Self>; 2];
}

macro_rules! on_a_line {
    ($($scalar:ty, in $meter:ty, by $metered:expr);* $(;)?) => {$(
        impl Metered for $scalar {
            type Meter = $meter;
            type Surface = $meter;

            #[inline(always)]
            fn metered(self) -> $meter {
                $metered(self)
            }

            #[inline(always)]
            fn coordinate(position: $meter, _criterion: &Criterion) -> $meter {
                position
            }

            #[inline(always)]
            fn magnitude(of: $meter) -> $meter {
                Scalar::magnitude(of)
            }

            fn surface(scenes: Scenes<'_>) -> Option<$meter> {
                let wall = |it: &Scene| it.environment.wall().map_or(0.0, |it| it.position.get());
                scenes.common().environment.wall().map(|_| scenes.each(wall))
            }

            #[inline(always)]
            fn pressed(surface: &$meter, position: $meter, force: $meter) -> [$meter; 2] {
                [position - *surface, force]
            }
        }
    )*};
}

on_a_line! {
    f64, in f64, by std::convert::identity;
    f32, in f64, by f64::from;
    F64x8, in F64x8, by std::convert::identity;
}

impl<T: Metered<Meter = f64> + Scalar<Mask = bool>, const N: usize> Metered for SVector<T, N>
where
    Self: Space<Scalar = T>,
    SVector<f64, N>: Space<Scalar = f64>,
{
    type Meter = SVector<f64, N>;
    type Surface = Box<dyn Solid<SVector<f64, N>>>;

    fn metered(self) -> SVector<f64, N> {
        SVector::from_fn(|axis, _| self[axis].metered())
    }

    fn coordinate(position: SVector<f64, N>, criterion: &Criterion) -> f64 {
        criterion.coordinate(position)
    }

    fn magnitude(of: SVector<f64, N>) -> f64 {
        of.length()
    }

    fn surface(scenes: Scenes<'_>) -> Option<Self::Surface> {
        SVector::solid(scenes.common())
    }

    fn pressed(
        surface: &Self::Surface,
        position: SVector<f64, N>,
        force: SVector<f64, N>,
    ) -> [f64; 2] {
        let NearestPoint { depth, normal } = surface.nearest(position);
        // A force that pushes out along the normal is felt as one against it.
        [depth, -force.dot(&normal)]
    }
}

/// Runs side by side, one in each lane.
struct Group<T: Metered, M: Metering> {
    rollout: Rollout<T>,
    fate: Fate<Number<T>>,
    meters: M::Meter<T::Meter>,
    share: Share<T::Meter>,
    /// The environment's own law; none of an environment with a mass.
    law: Option<Box<dyn ForceLaw<T::Meter>>>,
    surface: Option<T::Surface>,
    /// The lanes whose ticks were all in range.
    sound: <T::Scalar as Scalar>::Mask,
    /// The remaining ticks.
    left: u64,
    places: Vec<usize>,
    scenes: Vec<Scene>,
}

impl<T: Metered, M: Metering> Group<T, M> {
    #[inline(always)]
    fn tick(&mut self) {
        let tick = self.rollout.tick();
        self.sound = self.sound & tick.sound();
        let (position, velocity) = (tick.truth.position.metered(), tick.truth.velocity.metered());
        let coordinate = T::coordinate(position, self.fate.criterion(0));
        self.fate.add(coordinate, T::magnitude(velocity));
        let (applied, moved) = (tick.applied.metered(), tick.truth.displacement.metered());
        let split = self.share.of(tick.environment.metered(), applied);
        let none = [Number::<T>::of(0.0); 2];
        let pressed = |surface| T::pressed(surface, position, applied);
        self.meters.add(&Instant {
            position,
            coordinate,
            moved,
            work: tick.truth.applied.metered().inner(moved),
            applied,
            environment: split.environment,
            controller: split.controller,
            magnitudes: [T::magnitude(applied), T::magnitude(split.environment)],
            alpha: Number::<T>::from_lanes(|lane| tick.correction.alpha.lane(lane)),
            ideal: self.ideal(&tick),
            pressed: self.surface.as_ref().map_or(none, pressed),
        });
    }

    /// The force of the environment's own law on the true motion.
    #[inline(always)]
    fn ideal(&self, tick: &Tick<T>) -> T::Meter {
        let Some(law) = &self.law else { return T::Meter::zero() };
        law.force(&Kinematics {
            time: Time::Seconds(tick.time),
            position: tick.truth.position.metered(),
            velocity: tick.truth.velocity.metered(),
            acceleration: T::Meter::zero(),
        })
    }

    /// Whether the runs are at their end, or sure to grow.
    fn is_done(&self) -> bool {
        let is_lost = |lane| !self.sound.lane(lane) || self.fate.is_lost(lane);
        self.left == 0 || (0..self.places.len()).all(is_lost)
    }

    /// Writes the results at their places.
    fn read(&self, done: &mut Done<M>) {
        for (lane, (place, scene)) in self.places.iter().zip(&self.scenes).enumerate() {
            // Rows that end early have left the range of the numbers.
            let is_sound = self.sound.lane(lane);
            let verdict = if is_sound { self.fate.verdict(lane) } else { Verdict::Grows };
            let reading = (verdict != Verdict::Grows).then(|| self.meters.read(lane, ran(scene)));
            let verdict_by = self.fate.verdict_by(lane);
            done[*place] = Some(Judged { verdict, verdict_by, reading });
        }
    }
}

fn ran(scene: &Draft) -> Ran {
    let stiffness = scene.environment.surface_stiffness();
    Ran { rate: scene.servo_rate.get(), ticks: (scene.ticks() + 1) as f64, stiffness }
}

/// Some ticks of groups side by side.
struct Ticks<'a, T: Metered, M: Metering> {
    groups: &'a mut [Group<T, M>],
    count: u64,
}

impl<T: Metered, M: Metering> NullaryFnOnce for Ticks<'_, T, M> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        for _ in 0..self.count {
            for group in self.groups.iter_mut() {
                group.tick();
            }
        }
        for group in self.groups {
            group.left -= self.count;
        }
    }
}
