//! Closed loops whose numbers are arrays, on the lanes of maps.

use lyapunov::Scalar;
use lyapunov::bodies::Impedance;
use lyapunov::environments::Wall;
use lyapunov::stabilizers::{Member, NoStabilizer};
use lyapunov::{Correction, Dissipation, ParameterError, PortEnergy, PortSample, Requirement};
use pulp::NullaryFnOnce;
use rayon::prelude::*;

use super::Ends;
use super::batch::Batch;
use super::meter::Watch;
use super::numbers::Numbers;
use super::parts::{Accounted, Bodies};
use super::port::StabilizedWall;
use super::rollout::{Loop, STRETCH, WatchedLoop, run};
use super::sure::PERIODS;
#[cfg(target_arch = "x86_64")]
use super::{F64s, Proven, V3, V4, VECTORS};
use crate::measure::GoOn;
use crate::simulate::{F64x8, Instructions};

/// Ticks between two questions whether to go on, whole stretches.
const SLICE: u64 = STRETCH << 10;

/// Maker of the stabilizer of every loop.
pub trait Recipe: Sync {
    /// The stabilizer, with the same numbers in every lane.
    ///
    /// # Errors
    /// A number that it cannot have.
    fn make<T: Scalar>(&self) -> Result<Member<T, (PortEnergy, Dissipation<T>)>, ParameterError>;
}

/// Closed loops of a mass with damping on a hand's spring, moved exactly, against a one-sided wall that is sampled and held,
/// with a stabilizer at the servo's rate.
///
/// Every loop has the bits of the library's own parts: a [`Body`](lyapunov::bodies::Body), a [`Wall`] behind
/// [`OnePort::stabilized`](lyapunov::OnePort::stabilized) and
/// [`differenced`](lyapunov::effects::OnePortExt::differenced).
#[derive(Clone, Copy, Debug)]
pub struct Loops<'a> {
    /// Number of loops, as many as each array has numbers.
    pub count: usize,
    /// Ticks of each loop.
    pub ticks: u64,
    /// Time between two ticks, s.
    pub period: f64,
    /// Mass, kg, damping, N·s/m, and stiffness, N/m, of hand and device together; the hand rests at 0.
    pub impedance: Impedance<Numbers<'a>>,
    /// Position at the start, m.
    pub position: Numbers<'a>,
    /// Velocity at the start, m/s.
    pub velocity: Numbers<'a>,
    /// Stiffness of the wall, N/m.
    pub wall_stiffness: Numbers<'a>,
    /// Damping of the wall, N·s/m.
    pub wall_damping: Numbers<'a>,
    /// Where the wall begins, m.
    pub wall_position: Numbers<'a>,
}

impl Loops<'_> {
    /// The ends of all loops, in `room` for as many, on all threads of the present pool; none where `go_on`, which is asked now
    /// and then, stopped them.
    ///
    /// # Errors
    /// A number that a mass, a wall, a start or a stabilizer cannot have.
    pub fn ends(
        &self,
        mut room: Ends,
        recipe: &impl Recipe,
        go_on: &GoOn<'_>,
    ) -> Result<Option<Ends>, ParameterError> {
        self.check_places()?;
        let ends = &mut room;
        let is_whole = match Instructions::best() {
            Instructions::Base => self.under::<F64x8>(recipe, &|| (), go_on, ends),
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx2(proof) => {
                self.under::<F64s<V3, VECTORS>>(recipe, &|| proof.prove(), go_on, ends)
            }
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx512(proof) => {
                self.under::<F64s<V4, VECTORS>>(recipe, &|| proof.prove(), go_on, ends)
            }
        };
        Ok(is_whole?.then_some(room))
    }

    /// Writes the ends, with the type of the stabilizer; threads `prove` first that they may make a `T`. Whether it came to
    /// the end.
    fn under<T: Batch + Send + Sync>(
        &self,
        recipe: &impl Recipe,
        prove: &(dyn Fn() + Sync),
        go_on: &GoOn<'_>,
        ends: &mut Ends,
    ) -> Result<bool, ParameterError> {
        prove();
        match recipe.make::<T>()? {
            Member::NoStabilizer(_) => {
                self.spread::<T, _>(NoStabilizer, prove, go_on, ends, |ticks| T::run(ticks))
            }
            Member::Popc(popc) => {
                self.spread::<T, _>(popc, prove, go_on, ends, |ticks| T::run(ticks))
            }
            Member::Lolc(lolc) => {
                self.spread::<T, _>(lolc, prove, go_on, ends, |ticks| T::run(ticks))
            }
            // All others share one loop, which asks on every tick which it is: arrays spare one for each set of vectors.
            _ => {
                let member = recipe.make::<F64x8>()?;
                let run = |ticks: Ticks<'_, F64x8, _>| Instructions::best().run(ticks);
                self.spread::<F64x8, _>(member, prove, go_on, ends, run)
            }
        }
    }

    fn spread<T: Batch + Send + Sync, S: Accounted<T> + Send + Sync>(
        &self,
        stabilizer: S,
        prove: &(dyn Fn() + Sync),
        go_on: &GoOn<'_>,
        ends: &mut Ends,
        run: impl Fn(Ticks<'_, T, S>) + Sync,
    ) -> Result<bool, ParameterError> {
        let (width, are_moderate) = (T::BESIDE * T::LANES, self.are_moderate());
        let mut first = Bodies::none();
        self.group(0, &mut first, stabilizer, are_moderate)?;
        // Loops with one body in common have it from here.
        let start = || {
            prove();
            first.clone()
        };
        let parts = ends.position.par_chunks_mut(width).zip(ends.velocity.par_chunks_mut(width));
        let rest = ends.observed_energy.par_chunks_mut(width);
        let parts = parts.zip(rest.zip(ends.largest.par_chunks_mut(width))).enumerate();
        let ended = parts.try_for_each_init(start, |bodies, (at, parts)| {
            let ((position, velocity), (observed_energy, largest)) = parts;
            let starts = (at * width..self.count.min((at + 1) * width)).step_by(T::LANES);
            let groups = starts.map(|first| self.group(first, bodies, stabilizer, are_moderate));
            let mut groups = groups.collect::<Result<Vec<_>, _>>().map_err(Some)?;
            if !halves(&mut groups, self.ticks, go_on, &run) {
                return Err(None);
            }
            let places = position.iter_mut().zip(velocity).zip(observed_energy).zip(largest);
            for ((((position, velocity), observed_energy), largest), told) in
                places.zip(groups.iter().flat_map(Group::ends))
            {
                [*position, *velocity, *observed_energy, *largest] = told;
            }
            Ok(())
        });
        match ended {
            Ok(()) => Ok(true),
            Err(None) => Ok(false),
            Err(Some(error)) => Err(error),
        }
    }

    fn group<T: Batch, S: Accounted<T>>(
        &self,
        first: usize,
        bodies: &mut Bodies<T>,
        stabilizer: S,
        are_moderate: bool,
    ) -> Result<Group<T, S>, ParameterError> {
        let Impedance { mass, damping, stiffness } = self.impedance;
        let impedance = Impedance {
            mass: mass.lanes(first),
            damping: damping.lanes(first),
            stiffness: stiffness.lanes(first),
        };
        let body = bodies.of(impedance, T::of(self.period))?;
        let plant = body.starting(self.position.lanes(first), self.velocity.lanes(first));
        let wall = Wall::new(self.wall_stiffness.lanes(first), self.wall_damping.lanes(first));
        let wall = wall.map_err(of_wall)?;
        let surface = self.wall_position.lanes(first);
        let port = StabilizedWall::new(wall.at(surface), 1, stabilizer, self.period);
        let port = if are_moderate { port.sure(surface) } else { port };
        Ok(Group {
            looped: Loop::new(plant, port),
            seen: Seen { energy: T::zero(), reach: T::zero() },
        })
    }

    /// Checks what no part checks: where loops start, and where walls begin.
    fn check_places(&self) -> Result<(), ParameterError> {
        let named = [
            ("position", self.position),
            ("velocity", self.velocity),
            ("wall_position", self.wall_position),
        ];
        named.into_iter().try_for_each(|(parameter, numbers)| match numbers.infinite() {
            None => Ok(()),
            Some(value) => {
                Err(ParameterError { parameter, value, requirement: Requirement::Finite })
            }
        })
    }

    /// Whether all numbers of the walls are moderate.
    fn are_moderate(&self) -> bool {
        let walls = [self.wall_stiffness, self.wall_damping, self.wall_position];
        PERIODS.contains(&self.period) && walls.into_iter().all(Numbers::are_moderate)
    }
}

/// The loops of a group of lanes.
#[derive(Clone, Copy)]
struct Group<T: Batch, S> {
    looped: Loop<T, S>,
    seen: Seen<T>,
}

/// The view of some ticks.
#[derive(Clone, Copy)]
struct Seen<T> {
    /// The observed energy of the last tick with checks, J.
    energy: T,
    /// The largest |position|, m.
    reach: T,
}

/// The view while ticks run, written back at their end.
struct Seeing<'a, T> {
    seen: Seen<T>,
    into: &'a mut Seen<T>,
}

impl<T: Scalar> Watch<T> for Seeing<'_, T> {
    #[inline(always)]
    fn add(&mut self, sample: &PortSample<T>, _wall: T, correction: &Correction<T>) {
        self.seen.energy = correction.observed_energy;
        self.place(sample.position);
    }

    #[inline(always)]
    fn place(&mut self, position: T) {
        self.seen.reach = self.seen.reach.larger(position.magnitude());
    }

    #[inline(always)]
    fn reach(&self) -> T {
        self.seen.reach
    }

    #[inline(always)]
    fn end(self, _ticks: u64) {
        *self.into = self.seen;
    }
}

impl<T: Batch, S: Accounted<T>> Group<T, S> {
    /// Position, velocity, observed energy and largest |position|, lane by lane.
    fn ends(&self) -> impl Iterator<Item = [f64; 4]> {
        let Loop { sample, port, .. } = &self.looped;
        let energy = port.ahead().unwrap_or(self.seen.energy);
        let told = [sample.position, sample.velocity, energy, self.seen.reach];
        (0..T::LANES).map(move |lane| told.map(|number| number.lane(lane)))
    }
}

impl<T: Batch, S: Accounted<T>> WatchedLoop<T, S> for Group<T, S> {
    type Watch<'a>
        = Seeing<'a, T>
    where
        Self: 'a;

    #[inline(always)]
    fn apart(&mut self) -> (&mut Loop<T, S>, Seeing<'_, T>) {
        (&mut self.looped, self.seen.watch())
    }
}

impl<T: Copy> Seen<T> {
    #[inline(always)]
    fn watch(&mut self) -> Seeing<'_, T> {
        Seeing { seen: *self, into: self }
    }
}

/// All ticks of some groups; as for rollouts, every function between here and the arithmetic is always inlined.
struct Ticks<'a, T: Batch, S> {
    groups: &'a mut [Group<T, S>],
    ticks: u64,
}

impl<T: Batch, S: Accounted<T>> NullaryFnOnce for Ticks<'_, T, S> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let mut left = self.ticks;
        while left > 0 {
            let ticks = STRETCH.min(left);
            run(self.groups, ticks);
            left -= ticks;
        }
    }
}

/// Runs all ticks of `groups`, and forgets what they reached before half of them; whether `go_on` let it come to the end.
fn halves<T: Batch, S: Accounted<T>>(
    groups: &mut [Group<T, S>],
    ticks: u64,
    go_on: &GoOn<'_>,
    run: &impl Fn(Ticks<'_, T, S>),
) -> bool {
    let slices = |groups: &mut [Group<T, S>], ticks: u64| {
        let mut left = ticks;
        while left > 0 && go_on() {
            let ticks = SLICE.min(left);
            run(Ticks { groups, ticks });
            left -= ticks;
        }
        left == 0
    };
    // A tick sees the position before its motion: the first half ends before that at half of all ticks.
    let half = ticks.div_ceil(2);
    if !slices(groups, half) {
        return false;
    }
    for group in groups.iter_mut() {
        group.seen.reach = T::zero();
    }
    let is_whole = slices(groups, ticks - half);
    for Group { looped, seen } in groups {
        seen.reach = seen.reach.larger(looped.sample.position.magnitude());
    }
    is_whole
}

/// The error of a wall, by the name that the number has here.
fn of_wall(error: ParameterError) -> ParameterError {
    let parameter = match error.parameter {
        "stiffness" => "wall_stiffness",
        "damping" => "wall_damping",
        other => other,
    };
    ParameterError { parameter, ..error }
}
