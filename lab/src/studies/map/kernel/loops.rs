//! Closed loops whose numbers are arrays, on the lanes of maps.

use lyapunov::bodies::Impedance;
use lyapunov::environments::Wall;
use lyapunov::stabilizers::{Member, NoStabilizer};
use lyapunov::{Correction, Dissipation, ParameterError, Plant, PortEnergy, PortSample};
use lyapunov::{Scalar, Stabilizer};
use pulp::NullaryFnOnce;
use rayon::prelude::*;

use super::batch::Batch;
use super::meter::Watch;
use super::parts::Bodies;
use super::port::StabilizedWall;
use super::rollout::Loop;
#[cfg(target_arch = "x86_64")]
use super::{F64s, Proven, V3, V4, VECTORS};
use crate::simulate::{F64x8, Instructions};

/// A number of all loops, or one for each.
#[derive(Clone, Copy, Debug)]
pub enum Numbers<'a> {
    /// The same for all.
    All(f64),
    /// One for each.
    Each(&'a [f64]),
}

impl Numbers<'_> {
    /// The numbers of the loops from `first` on; lanes beyond the last loop repeat it.
    fn lanes<T: Scalar>(self, first: usize) -> T {
        match self {
            Self::All(number) => T::of(number),
            Self::Each(numbers) => T::from_lanes(|lane| {
                let number = numbers.get(first + lane).or(numbers.last());
                number.copied().unwrap_or(f64::NAN)
            }),
        }
    }
}

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

/// How loops ended, a number for each.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ends {
    /// Position, m.
    pub position: Vec<f64>,
    /// Velocity, m/s.
    pub velocity: Vec<f64>,
    /// Observed energy at the last tick, J.
    pub observed_energy: Vec<f64>,
    /// The largest |position| in the second half, m.
    pub largest: Vec<f64>,
}

impl Loops<'_> {
    /// The ends of all loops, on all threads of the present pool.
    ///
    /// # Errors
    /// A number that a mass, a wall or a stabilizer cannot have.
    pub fn ends(&self, recipe: &impl Recipe) -> Result<Ends, ParameterError> {
        match Instructions::best() {
            Instructions::Base => self.under::<F64x8>(recipe, &|| ()),
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx2(proof) => self.under::<F64s<V3, VECTORS>>(recipe, &|| proof.prove()),
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx512(proof) => {
                self.under::<F64s<V4, VECTORS>>(recipe, &|| proof.prove())
            }
        }
    }

    /// The ends with the type of the stabilizer; threads `prove` first that they may make a `T`.
    fn under<T: Batch + Send + Sync>(
        &self,
        recipe: &impl Recipe,
        prove: &(dyn Fn() + Sync),
    ) -> Result<Ends, ParameterError> {
        prove();
        match recipe.make::<T>()? {
            Member::NoStabilizer(_) => {
                self.spread::<T, _>(NoStabilizer, prove, |ticks| T::run(ticks))
            }
            Member::Popc(popc) => self.spread::<T, _>(popc, prove, |ticks| T::run(ticks)),
            Member::Lolc(lolc) => self.spread::<T, _>(lolc, prove, |ticks| T::run(ticks)),
            // All others share one loop, which asks on every tick which it is: arrays spare one for each set of vectors.
            _ => {
                let member = recipe.make::<F64x8>()?;
                self.spread::<F64x8, _>(member, prove, |ticks| Instructions::best().run(ticks))
            }
        }
    }

    fn spread<T: Batch + Send + Sync, S: Stabilizer<T> + Copy + Send + Sync>(
        &self,
        stabilizer: S,
        prove: &(dyn Fn() + Sync),
        run: impl Fn(Ticks<'_, T, S>) + Sync,
    ) -> Result<Ends, ParameterError> {
        let width = T::BESIDE * T::LANES;
        let start = || {
            prove();
            Bodies::none()
        };
        let shares =
            (0..self.count.div_ceil(width)).into_par_iter().map_init(start, |bodies, at| {
                let starts = (at * width..self.count.min((at + 1) * width)).step_by(T::LANES);
                let groups = starts.map(|first| self.group(first, bodies, stabilizer));
                let mut groups = groups.collect::<Result<Vec<_>, _>>()?;
                run(Ticks { groups: &mut groups, ticks: self.ticks });
                Ok::<_, ParameterError>(groups.iter().flat_map(Group::ends).collect())
            });
        let shares: Vec<Vec<[f64; 4]>> = shares.collect::<Result<_, _>>()?;
        let mut ends = Ends::default();
        for [position, velocity, observed_energy, largest] in
            shares.concat().into_iter().take(self.count)
        {
            ends.position.push(position);
            ends.velocity.push(velocity);
            ends.observed_energy.push(observed_energy);
            ends.largest.push(largest);
        }
        Ok(ends)
    }

    fn group<T: Batch, S: Stabilizer<T>>(
        &self,
        first: usize,
        bodies: &mut Bodies<T>,
        stabilizer: S,
    ) -> Result<Group<T, S>, ParameterError> {
        let Impedance { mass, damping, stiffness } = self.impedance;
        let impedance = Impedance {
            mass: mass.lanes(first),
            damping: damping.lanes(first),
            stiffness: stiffness.lanes(first),
        };
        let body = bodies.of(impedance, T::of(self.period))?;
        let plant = body.starting(self.position.lanes(first), self.velocity.lanes(first));
        let wall = Wall::new(self.wall_stiffness.lanes(first), self.wall_damping.lanes(first))?;
        let wall = wall.at(self.wall_position.lanes(first));
        let port = StabilizedWall::new(wall, 1, stabilizer, self.period);
        let looped = Loop { plant, port, sample: plant.start() };
        Ok(Group { looped, energy: Last(T::zero()), largest: T::zero() })
    }
}

/// The loops of a group of lanes.
#[derive(Clone, Copy)]
struct Group<T: Batch, S> {
    looped: Loop<T, S>,
    energy: Last<T>,
    largest: T,
}

/// The last observed energy, J.
#[derive(Clone, Copy)]
struct Last<T>(T);

impl<T: Scalar> Watch<T> for &mut Last<T> {
    #[inline(always)]
    fn add(&mut self, _sample: &PortSample<T>, _wall: T, correction: &Correction<T>) {
        self.0 = correction.observed_energy;
    }

    fn place(&mut self, _position: T) {}

    fn reach(&self) -> T {
        T::largest()
    }

    #[inline(always)]
    fn end(self, _ticks: u64) {}
}

impl<T: Batch, S: Stabilizer<T> + Copy> Group<T, S> {
    /// Position, velocity, observed energy and largest |position|, lane by lane.
    fn ends(&self) -> impl Iterator<Item = [f64; 4]> {
        let sample = &self.looped.sample;
        let told = [sample.position, sample.velocity, self.energy.0, self.largest];
        (0..T::LANES).map(move |lane| told.map(|number| number.lane(lane)))
    }

    #[inline(always)]
    fn early(&mut self) {
        self.looped.tick(&mut &mut self.energy);
    }

    #[inline(always)]
    fn late(&mut self) {
        self.early();
        self.largest = self.largest.larger(self.looped.sample.position.magnitude());
    }
}

/// All ticks of some groups; as for rollouts, every function between here and the arithmetic is always inlined.
struct Ticks<'a, T: Batch, S> {
    groups: &'a mut [Group<T, S>],
    ticks: u64,
}

impl<T: Batch, S: Stabilizer<T> + Copy> NullaryFnOnce for Ticks<'_, T, S> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let half = self.ticks.div_ceil(2);
        if T::IN_REGISTERS {
            for group in self.groups {
                let mut own = *group;
                (0..half).for_each(|_| own.early());
                (half..self.ticks).for_each(|_| own.late());
                *group = own;
            }
            return;
        }
        for _ in 0..half {
            self.groups.iter_mut().for_each(Group::early);
        }
        for _ in half..self.ticks {
            self.groups.iter_mut().for_each(Group::late);
        }
    }
}
