//! Faults at every tick of a scene.
//!
//! A run has one kind of fault, again and again: [`SPACING`] ticks apart, from some tick on. As many runs as there are
//! ticks between two faults spoil every tick of the scene.

mod fault;
mod spoilt;
mod witness;

pub use fault::{Fault, Field};
pub use witness::Broken;

use std::cell::RefCell;
use std::fmt;
use std::rc::Rc;

use lyapunov::ParameterError;
use nalgebra::SVector;
use rayon::prelude::*;

use self::spoilt::spoilt;
use self::witness::Witness;
use super::looped::{named_in, terms};
use super::terms::{Terms, Unsound};
use crate::files::Scene;
use crate::simulate::{Fitted, Rollout, Space};

/// Ticks between two faults of a run.
pub const SPACING: u64 = 16;

/// Ticks after a fault from which on every sample is accepted.
pub const RECOVERY: u64 = 1;

/// The faults of a run.
#[derive(Clone, Copy, Debug)]
struct Plan {
    fault: Fault,
    first: u64,
}

impl Plan {
    /// The fault of a tick. Before the first one there is a sample of zeros, which took no time.
    fn at(&self, tick: u64) -> Option<Fault> {
        (tick % SPACING == self.first).then_some(self.fault)
    }
}

/// Faults swept through the ticks of a scene.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Swept {
    /// The faults.
    pub faults: u64,
    /// The most ticks after a fault until every sample is accepted; 0 where a fault itself is accepted.
    pub recovery: u64,
    /// The first fault after which something is not kept.
    pub found: Option<Found>,
}

/// Fault after which something is not kept.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// The fault.
    pub fault: Fault,
    /// The first tick that has it; others follow, [`SPACING`] ticks apart.
    pub first: u64,
    /// The kind of number that the loop ran in.
    pub numbers: &'static str,
    /// The promise that is not kept.
    pub broken: Broken,
    /// The tick that was told to the stabilizer when it was not kept.
    pub tick: u64,
}

impl Swept {
    fn and(self, other: Self) -> Self {
        Self {
            faults: self.faults + other.faults,
            recovery: self.recovery.max(other.recovery),
            found: self.found.or(other.found),
        }
    }
}

impl fmt::Display for Found {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { fault, first, numbers, broken, tick } = self;
        write!(f, "in {numbers}, {fault} at tick {first} and so on, sample {tick}: {broken}")
    }
}

/// Every fault at each tick of `scene` that is one of `firsts` modulo [`SPACING`], up to tick `last`, in `f64` and, if its
/// numbers fit, in `f32`.
///
/// # Errors
/// A parameter that is right by itself but out of the range of `f64`, alone or with others.
pub fn sweep(scene: &Scene, firsts: &[u64], last: u64) -> Result<Swept, ParameterError> {
    let sweep = match scene.dimensions() {
        1 => in_both::<f64, f32>,
        2 => in_both::<SVector<f64, 2>, SVector<f32, 2>>,
        _ => in_both::<SVector<f64, 3>, SVector<f32, 3>>,
    };
    let plans = firsts
        .iter()
        .flat_map(|&first| Fault::all().into_iter().map(move |fault| Plan { fault, first }));
    let plans: Vec<Plan> = plans.collect();
    plans
        .into_par_iter()
        .map(|plan| sweep(scene, plan, last))
        .try_reduce(Swept::default, |one, other| Ok(one.and(other)))
}

fn in_both<D: Space, S: Space>(
    scene: &Scene,
    plan: Plan,
    last: u64,
) -> Result<Swept, ParameterError> {
    let double = run::<D>(scene, plan, last, "f64")?;
    // A scene whose numbers do not fit f32 is not run in f32.
    let single = run::<S>(scene, plan, last, "f32").unwrap_or_default();
    Ok(double.and(single))
}

fn run<V: Space>(
    scene: &Scene,
    plan: Plan,
    last: u64,
    numbers: &'static str,
) -> Result<Swept, ParameterError> {
    let terms = terms(scene, 0.0, named_in::<V>(scene));
    let terms = Terms { unsound: Unsound::Fault, ..terms };
    let witness = Rc::new(RefCell::new(Witness::new::<V>(terms)));
    let fitted = spoilt(Fitted::<V>::of(scene)?, plan, &witness);
    let mut rollout = Rollout::assemble(scene, fitted)?;
    for _ in 0..=last.min(scene.ticks()) {
        rollout.tick();
    }
    let witness = witness.borrow();
    let Plan { fault, first } = plan;
    let found = |(broken, tick)| Found { fault, first, numbers, broken, tick };
    Ok(Swept {
        faults: witness.faults,
        recovery: witness.recovery,
        found: witness.broken().map(found),
    })
}
