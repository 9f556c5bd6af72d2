//! The kernel of a map: many cells at once, as lanes of one generic rollout on the processor's vector instructions.
//!
//! The rollout consists of the library's own parts: a [`Body`](lyapunov::bodies::Body), a
//! [`Wall`](lyapunov::environments::Wall) behind a hold, backward differences and any of the stabilizers of a scene
//! over held work. Every lane equals a run by itself bit for bit. Scenes with other parts run on lanes of boxes,
//! see [`Runs`].

mod backward;
mod batch;
mod ends;
mod field;
mod loops;
mod meter;
mod numbers;
mod parts;
mod placed;
mod port;
#[cfg(any(target_arch = "x86_64", target_feature = "simd128"))]
mod proven;
mod rollout;
mod seats;
mod sure;
#[cfg(any(target_arch = "x86_64", target_feature = "simd128"))]
mod vectors;

use lyapunov::lanes::AutoF32x16;
#[cfg(not(target_feature = "simd128"))]
use lyapunov::lanes::AutoF64x8;
use lyapunov::{
    Dissipation, Lolc, ParameterError, PortEnergy, Scalar, candidates::InContact,
    stabilizers::NoStabilizer,
};

#[cfg(target_feature = "simd128")]
use pulp::wasm::Simd128;
#[cfg(target_arch = "x86_64")]
use pulp::x86::{V3, V4};

use crate::files::scene::{
    Candidate, Draft, Integrator, Ledger, Scalar as Width, Scene, Stabilizer, Velocity, Work,
};
use crate::measure::runs::Measures;
#[cfg(doc)]
use crate::measure::runs::Runs;
use crate::measure::{GoOn, Verdict, Yardstick};
use crate::simulate::family::{BasicName, Settings};
use crate::simulate::{Aligned, Instructions};
use crate::studies::map::grid::{Grid, GridError};
use batch::Batch;
pub use ends::Ends;
pub use loops::{Loops, Recipe};
use meter::{Everything, Meter, Verdicts};
pub use numbers::Numbers;
use parts::Laned;
pub(super) use placed::Placed;
#[cfg(target_arch = "x86_64")]
use proven::Proven;
use rollout::Rollouts;
use seats::{Along, Seats};
#[cfg(target_arch = "x86_64")]
use vectors::F32s;
#[cfg(any(target_arch = "x86_64", target_feature = "simd128"))]
use vectors::F64s;

/// The most ticks of a run in `f32`, which cannot count more.
const COUNTED: u64 = 1 << 24;

/// Rollouts of a map on lanes.
#[derive(Debug)]
pub struct Kernel {
    along: Along,
    /// The same for the stabilizer whose table an axis is over; to the others that axis does nothing.
    named: Option<(BasicName, Along)>,
    instructions: Instructions,
    lanes: Lanes,
}

/// Number of rollouts that run side by side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lanes {
    /// One at a time, the reference for the speed of the lanes.
    One,
    /// As many as fill two vectors, or those that the compiler finds vectors for.
    Many,
}

impl Kernel {
    /// Kernel for `grid`; none if its scene has parts that the kernel does not.
    ///
    /// # Errors
    /// A value of an axis that the scene does not allow.
    pub fn of(
        grid: &Grid,
        instructions: Instructions,
        lanes: Lanes,
    ) -> Result<Option<Self>, GridError> {
        let copiers = [(0, &grid.x.key), (1, &grid.y.key)].map(|(which, key)| {
            if grid.member(which).is_some() { Some(field::NOTHING) } else { field::copier(key) }
        });
        let [Some(x), Some(y)] = copiers else { return Ok(None) };
        if !covers(&grid.scene) {
            return Ok(None);
        }
        let base = grid.scene.to_draft();
        let (xs, ys) = (grid.along(0)?, grid.along(1)?);
        let named = [0, 1].into_iter().find_map(|which| grid.member(which)?.basic_name());
        let named = named.map(|name| {
            let is_named =
                |which| grid.member(which).is_some_and(|it| it.basic_name() == Some(name));
            let copier = |which, usual| if is_named(which) { field::CAP } else { usual };
            let base = Draft { stabilizer: name.table(&base), ..base.clone() };
            (name, Along { base, x: (xs.clone(), copier(0, x)), y: (ys.clone(), copier(1, y)) })
        });
        let along = Along { base, x: (xs, x), y: (ys, y) };
        let counted = |scenes: &[Scene]| scenes.iter().all(|scene| scene.ticks() < COUNTED);
        let fits = grid.scene.scalar == Width::F64 || counted(&along.x.0) && counted(&along.y.0);
        Ok(fits.then_some(Self { along, named, instructions, lanes }))
    }

    /// The scenes along both axes for `basic_name`.
    fn along(&self, basic_name: BasicName) -> &Along {
        let named = self.named.as_ref().filter(|(name, _)| *name == basic_name);
        named.map_or(&self.along, |(_, along)| along)
    }

    /// Number of rollouts that run side by side.
    pub fn lanes(&self) -> usize {
        let is_wide = self.along.base.scalar == Width::F64;
        match (self.lanes, self.instructions) {
            (Lanes::One, _) => 1,
            (Lanes::Many, Instructions::Base) if is_wide => BaseF64s::LANES,
            (Lanes::Many, Instructions::Base) => AutoF32x16::LANES,
            #[cfg(target_arch = "x86_64")]
            (Lanes::Many, Instructions::Avx2(_)) => lanes_of::<V3>(is_wide),
            #[cfg(target_arch = "x86_64")]
            (Lanes::Many, Instructions::Avx512(_)) => lanes_of::<V4>(is_wide),
        }
    }

    /// The vector instructions that the kernel uses.
    pub fn instructions(&self) -> Instructions {
        self.instructions
    }

    /// The verdict on the run of each of `cells` under `basic_name`, and the quantity that it is judged by. A run that is
    /// sure to grow is not run to its end.
    ///
    /// Polls `go_on` now and then; none if it returned false.
    ///
    /// # Errors
    /// A parameter out of the range of the scalar.
    pub fn verdicts(
        &self,
        basic_name: BasicName,
        cells: &[u64],
        go_on: &GoOn<'_>,
    ) -> Result<Option<Vec<(Verdict, Yardstick)>>, ParameterError> {
        self.run::<Judge>(Run { kernel: self, basic_name, cells, go_on })
    }

    /// The same for a scene in `f64`, always on lanes. It is compiled for the caller's crate, so that a program that is built
    /// for size can have this one loop built for speed.
    ///
    /// # Errors
    /// Those of [`Kernel::verdicts`].
    #[inline]
    pub fn verdicts_in_f64(
        &self,
        basic_name: BasicName,
        cells: &[u64],
    ) -> Result<Vec<(Verdict, Yardstick)>, ParameterError> {
        let run = Run { kernel: self, basic_name, cells, go_on: &|| true };
        Ok(run.on::<BaseF64s, Judge>()?.unwrap_or_default())
    }

    /// Measures of the runs of `cells` under `basic_name`.
    ///
    /// Polls `go_on` now and then; none if it returned false.
    ///
    /// # Errors
    /// A parameter out of the range of the scalar.
    pub fn measures(
        &self,
        basic_name: BasicName,
        cells: &[u64],
        go_on: &GoOn<'_>,
    ) -> Result<Option<Vec<Measures>>, ParameterError> {
        self.run::<MeasureAll>(Run { kernel: self, basic_name, cells, go_on })
    }

    fn run<W: Watching>(&self, run: Run<'_>) -> Readings<W::Reading> {
        let is_wide = self.along.base.scalar == Width::F64;
        match (self.lanes, self.instructions) {
            (Lanes::One, _) if is_wide => run.on::<f64, W>(),
            (Lanes::One, _) => run.on::<f32, W>(),
            (Lanes::Many, Instructions::Base) if is_wide => run.on::<BaseF64s, W>(),
            (Lanes::Many, Instructions::Base) => run.on::<Aligned<AutoF32x16>, W>(),
            #[cfg(target_arch = "x86_64")]
            (Lanes::Many, Instructions::Avx2(proof)) => {
                proof.prove();
                run.on_vectors::<V3, W>(is_wide)
            }
            #[cfg(target_arch = "x86_64")]
            (Lanes::Many, Instructions::Avx512(proof)) => {
                proof.prove();
                run.on_vectors::<V4, W>(is_wide)
            }
        }
    }
}

/// Vectors of a group: one computes while another waits for a quotient, as do the two groups that run side by side. With more, every
/// run waits for more others. Short ones are in one group, which takes less code.
#[cfg(any(target_arch = "x86_64", target_feature = "simd128"))]
const VECTORS: usize = if cfg!(target_feature = "simd128") { 4 } else { 2 };

/// Lanes of `f64` that every processor of the target has.
#[cfg(not(target_feature = "simd128"))]
type BaseF64s = Aligned<AutoF64x8>;
#[cfg(target_feature = "simd128")]
type BaseF64s = F64s<Simd128, VECTORS>;

/// Lanes of a group on vectors of `S`.
#[cfg(target_arch = "x86_64")]
fn lanes_of<S: Proven>(is_wide: bool) -> usize {
    if is_wide { F64s::<S, VECTORS>::LANES } else { F32s::<S, VECTORS>::LANES }
}

/// Whether the kernel has all parts of a scene.
fn covers(scene: &Scene) -> bool {
    let plain = Draft {
        duration: scene.duration,
        servo_rate: scene.servo_rate,
        environment_rate: scene.environment_rate,
        velocity: Velocity::BackwardDifference,
        scalar: scene.scalar,
        integrator: Integrator::Exact,
        operator: crate::files::scene::Operator {
            motion: None,
            grip: None,
            ..scene.operator.clone()
        },
        device: scene.device,
        link: None,
        space: None,
        initial: scene.initial.clone(),
        environment: scene.environment.clone(),
        stabilizer: scene.stabilizer,
        effects: Default::default(),
    };
    let Settings { work, ledger, .. } = Settings::of(scene);
    let booked = work == Work::Held && ledger == Ledger::Plain;
    scene.environment.wall().is_some() && booked && plain == **scene
}

/// Some cells under one stabilizer.
struct Run<'a> {
    kernel: &'a Kernel,
    basic_name: BasicName,
    cells: &'a [u64],
    go_on: &'a GoOn<'a>,
}

/// Meter of rollouts, on lanes of any scalar.
trait Watching {
    type Reading: Copy + Send;
    type Meter<T: Batch>: Meter<T, Reading = Self::Reading>;

    fn empty() -> Self::Reading;
}

/// A reading of every cell; none if the run was stopped.
type Readings<R> = Result<Option<Vec<R>>, ParameterError>;

struct Judge;

impl Watching for Judge {
    type Reading = (Verdict, Yardstick);
    type Meter<T: Batch> = Verdicts<T>;

    fn empty() -> (Verdict, Yardstick) {
        (Verdict::TooShort, Yardstick::Distance)
    }
}

struct MeasureAll;

impl Watching for MeasureAll {
    type Reading = Measures;
    type Meter<T: Batch> = Everything<T>;

    fn empty() -> Measures {
        Measures::default()
    }
}

impl Run<'_> {
    /// Runs the rollouts on vectors of instructions that the thread has proven, `f64` or `f32`.
    #[cfg(target_arch = "x86_64")]
    fn on_vectors<S: Proven, W: Watching>(self, is_wide: bool) -> Readings<W::Reading> {
        match is_wide {
            true => self.on::<F64s<S, VECTORS>, W>(),
            false => self.on::<F32s<S, VECTORS>, W>(),
        }
    }

    /// Runs the rollouts with the type of the stabilizer.
    fn on<T: Batch, W: Watching>(self) -> Readings<W::Reading> {
        type DeviceDamped<T> = (PortEnergy, Dissipation<T>);
        type WallDamped<T> = (PortEnergy, Dissipation<T, InContact<T>>);
        let candidate = match self.basic_name.table(&self.kernel.along(self.basic_name).base) {
            None => return self.under::<T, NoStabilizer, W>(),
            Some(Stabilizer::Lolc(lolc)) => lolc.candidate,
            // POPC: no other has a basic name.
            Some(_) => Candidate::Spring,
        };
        match candidate {
            Candidate::Spring => self.under::<T, Lolc<T, PortEnergy>, W>(),
            Candidate::DeviceDamping => self.under::<T, Lolc<T, DeviceDamped<T>>, W>(),
            Candidate::MassSpringDamper => self.under::<T, Lolc<T, WallDamped<T>>, W>(),
        }
    }

    fn under<T: Batch, S: Laned<T>, W: Watching>(self) -> Readings<W::Reading> {
        let seats = Seats::new(self.kernel.along(self.basic_name), self.cells);
        T::run(Rollouts::<T, S, W::Meter<T>>::new(seats, W::empty(), self.go_on))
    }
}
