//! Runs of cells whose loops are built of boxes: on lanes where they are alike, and else one by one.

use lyapunov::environments::{ForceLaw, Kinematics, Time};
use lyapunov::{Mask, ParameterError, Scalar};
use pulp::NullaryFnOnce;

use super::alike::{groups, has_lanes};
use super::meters::{Instant, Meters, Ran};
use super::outcome::{Measures, Outcome};
use crate::files::scene::{Draft, Lanes, Scalar as Width, Scene, Stabilizer, law_of_lanes};
use crate::measure::{Fate, Share, Verdict, device_damper};
use crate::simulate::family::StabilizerName;
use crate::simulate::{F64x8, Fitted, Instructions, Rollout, Scenes, Space, Tick};

/// Ticks between two checks whether verdicts are decided.
const STRETCH: u64 = 64;

/// Groups of lanes that run side by side: one computes while another waits.
const BESIDE: usize = 2;

/// Cells under one stabilizer.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cells<'a> {
    /// The scene of each cell.
    pub(super) scenes: &'a [Scene],
    /// The stabilizer.
    pub(super) member: StabilizerName,
    /// The instructions of lanes; none runs each cell by itself.
    pub(super) instructions: Option<Instructions>,
}

/// A parameter out of the range of the scalar, and the place of its cell.
pub(super) type Refused = (usize, ParameterError);

impl Cells<'_> {
    /// Outcomes of the runs; none if `go_on` stopped them. A lost run is not run to its end.
    ///
    /// # Errors
    /// A parameter out of the range of the scalar.
    pub(super) fn outcomes(
        self,
        go_on: &(dyn Fn() -> bool + Sync),
    ) -> Result<Option<Vec<Outcome>>, Refused> {
        let tables: Vec<_> = self.scenes.iter().map(|it| self.member.table(it)).collect();
        let work = Work { cells: self, tables: &tables, go_on };
        let mut done = vec![None; self.scenes.len()];
        let mut alone: Vec<Vec<usize>> = Vec::new();
        let fit = || self.scenes.iter().zip(&tables).all(|(it, table)| has_lanes(it, table));
        match self.instructions.filter(|_| fit()) {
            None => alone.extend((0..self.scenes.len()).map(|place| vec![place])),
            Some(instructions) => {
                let groups = groups(self.scenes, &tables, F64x8::LANES);
                let (several, single): (Vec<_>, Vec<_>) =
                    groups.into_iter().partition(|group| group.len() > 1);
                alone.extend(single);
                match work.run::<F64x8>(several, instructions, &mut done)? {
                    None => return Ok(None),
                    Some(refused) => alone.extend(refused),
                }
            }
        }
        // All scenes of a map have the same scalar.
        let base = Instructions::Base;
        let finished = match self.scenes.first().map(|scene| scene.scalar) {
            Some(Width::F32) => work.run::<f32>(alone, base, &mut done)?,
            _ => work.run::<f64>(alone, base, &mut done)?,
        };
        Ok(finished.and_then(|_| done.into_iter().collect()))
    }
}

/// Cells with their tables.
struct Work<'a> {
    cells: Cells<'a>,
    tables: &'a [Option<Stabilizer>],
    go_on: &'a (dyn Fn() -> bool + Sync),
}

impl Work<'_> {
    /// Runs `groups` of places and writes their outcomes; returns those places that have to run by themselves, for one of
    /// their group has a parameter out of range, and none if it was stopped.
    fn run<T: Metered>(
        &self,
        groups: Vec<Vec<usize>>,
        instructions: Instructions,
        done: &mut [Option<Outcome>],
    ) -> Result<Option<Vec<Vec<usize>>>, Refused> {
        let beside = if T::LANES == 1 { 1 } else { BESIDE };
        let (mut waiting, mut refused) = (groups.into_iter(), Vec::new());
        let mut running: Vec<Group<T>> = Vec::with_capacity(beside);
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
                    group.read(self.cells.member, done);
                }
                !is_done
            });
        }
    }

    fn group<T: Metered>(
        &self,
        places: &[usize],
        instructions: Instructions,
    ) -> Result<Group<T>, ParameterError> {
        let scenes: Vec<Scene> = places.iter().map(|at| self.cells.scenes[*at].clone()).collect();
        let tables: Vec<_> = places.iter().map(|at| self.tables[*at]).collect();
        let on = Scenes::on(&scenes, instructions);
        let rollout = Rollout::on(on, Fitted::on(on, &tables)?)?;
        let metered = |number: T| number.metered();
        let fate = Fate::of_lanes(scenes.iter().map(|scene| &**scene));
        let rest = |lane: usize| fate.criterion(lane.min(scenes.len() - 1)).rest();
        let band =
            (T::Meter::from_lanes(|lane| rest(lane).0), T::Meter::from_lanes(|lane| rest(lane).1));
        let limit = |it: &Scene| it.effects.saturation.map_or(f64::INFINITY, |it| it.force.get());
        let common = on.common();
        let wall = |it: &Scene| it.environment.wall().map_or(0.0, |it| it.position.get());
        let damper = T::Meter::from_lanes(|lane| device_damper(on.lane(lane)));
        let impedance = common.environment.kind().impedance();
        let is_massless = impedance.is_none_or(|it| it.mass == 0.0);
        Ok(Group {
            rollout,
            fate,
            meters: Meters::new(common.servo_rate.get(), damper, band),
            // Rounded as the loop rounds it.
            share: Share::late(common.delay_ticks() as usize, metered(on.each(limit))),
            law: is_massless.then(|| law_of_lanes(Lanes::new(&scenes))).flatten(),
            surface: common.environment.wall().map(|_| on.each(wall)),
            sound: <T::Meter as Scalar>::Mask::of(true),
            left: common.ticks() + 1,
            places: places.to_vec(),
            scenes,
        })
    }
}

/// A scalar of loops, and that of the meters along them.
trait Metered: Scalar + Space {
    type Meter: Scalar<Mask = Self::Mask>;

    fn metered(self) -> Self::Meter;
}

impl Metered for f64 {
    type Meter = f64;

    #[inline(always)]
    fn metered(self) -> f64 {
        self
    }
}

impl Metered for f32 {
    type Meter = f64;

    #[inline(always)]
    fn metered(self) -> f64 {
        self.into()
    }
}

impl Metered for F64x8 {
    type Meter = Self;

    #[inline(always)]
    fn metered(self) -> Self {
        self
    }
}

/// Runs side by side, one in each lane.
struct Group<T: Metered> {
    rollout: Rollout<T>,
    fate: Fate<T::Meter>,
    meters: Meters<T::Meter>,
    share: Share<T::Meter>,
    /// The environment's own law; none of an environment with a mass.
    law: Option<Box<dyn ForceLaw<T::Meter>>>,
    /// The surface of the wall, if the environment is one.
    surface: Option<T::Meter>,
    /// The lanes whose ticks were all in range.
    sound: T::Mask,
    /// The remaining ticks.
    left: u64,
    places: Vec<usize>,
    scenes: Vec<Scene>,
}

impl<T: Metered> Group<T> {
    #[inline(always)]
    fn tick(&mut self) {
        let tick = self.rollout.tick();
        self.sound = self.sound & tick.sound();
        let (position, velocity) = (tick.truth.position.metered(), tick.truth.velocity.metered());
        self.fate.add(position, velocity);
        let (applied, moved) = (tick.applied.metered(), tick.truth.displacement.metered());
        let split = self.share.of(tick.environment.metered(), applied);
        let zero = T::Meter::of(0.0);
        self.meters.add(&Instant {
            position,
            moved,
            work: tick.truth.applied.metered() * moved,
            applied,
            environment: split.environment,
            controller: split.controller,
            alpha: tick.correction.alpha.metered(),
            ideal: self.ideal(&tick),
            depth: self.surface.map_or(zero, |surface| position - surface),
        });
    }

    /// The force of the environment's own law on the true motion.
    #[inline(always)]
    fn ideal(&self, tick: &Tick<T>) -> T::Meter {
        let Some(law) = &self.law else { return T::Meter::of(0.0) };
        law.force(&Kinematics {
            time: Time::Seconds(tick.time),
            position: tick.truth.position.metered(),
            velocity: tick.truth.velocity.metered(),
            acceleration: T::Meter::of(0.0),
        })
    }

    /// Whether the runs are at their end, or sure to grow.
    fn is_done(&self) -> bool {
        let is_lost = |lane| !self.sound.lane(lane) || self.fate.is_lost(lane);
        self.left == 0 || (0..self.places.len()).all(is_lost)
    }

    /// Writes the outcomes under `member` at their places.
    fn read(&self, member: StabilizerName, done: &mut [Option<Outcome>]) {
        for (lane, (place, scene)) in self.places.iter().zip(&self.scenes).enumerate() {
            // Rows that end early have left the range of the numbers.
            let is_sound = self.sound.lane(lane);
            let verdict = if is_sound { self.fate.verdict(lane) } else { Verdict::Grows };
            let measures = match verdict {
                Verdict::Grows => Measures::default(),
                _ => {
                    let measures = self.meters.read(lane, ran(scene));
                    let active = measures.active.filter(|_| member.adds_damping());
                    Measures { active, ..measures }
                }
            };
            let verdict_by = self.fate.verdict_by(lane);
            done[*place] = Some(Outcome { verdict, verdict_by, measures });
        }
    }
}

fn ran(scene: &Draft) -> Ran {
    let stiffness = scene.environment.wall().map(|wall| wall.stiffness.get());
    Ran { rate: scene.servo_rate.get(), ticks: (scene.ticks() + 1) as f64, stiffness }
}

/// Some ticks of groups side by side.
struct Ticks<'a, T: Metered> {
    groups: &'a mut [Group<T>],
    count: u64,
}

impl<T: Metered> NullaryFnOnce for Ticks<'_, T> {
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
