//! Sweep of one number of a scene, under several stabilizers.

mod document;
mod picture;
mod report;
mod table;

use rayon::prelude::*;

use super::axis::Axis;
use super::grid::GridError;
use super::run_error::RunError;
use super::threads;
use super::varied::Variation;
use super::vary::{VaryError, no_scene};
use crate::files::Scene;
use crate::simulate::family::{StabilizerName, StabilizerNames};
use crate::studies::compare::{self, Score, SharedWatch};

/// A scene with one of its numbers varied, under several stabilizers: the runs to come.
#[derive(Clone, Debug)]
pub struct SweepPlan {
    name: String,
    scene: Scene,
    x: Axis,
    stabilizers: StabilizerNames,
    /// The scene of each value under each stabilizer.
    scenes: Vec<Vec<Scene>>,
}

/// The runs of a sweep; its `Display` is the text of the terminal.
#[derive(Clone, Debug)]
pub struct Sweep {
    /// The name of the scene.
    pub name: String,
    /// The scene whose number is varied.
    pub scene: Scene,
    /// The number and its values.
    pub x: Axis,
    /// The stabilizers that run at each value.
    pub stabilizers: StabilizerNames,
    /// The values, in their order.
    pub points: Vec<Point>,
}

/// One value of a sweep.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// The value.
    pub value: f64,
    /// The score of each stabilizer, as `lyapunov compare` tells it; the time of a step is not measured.
    pub scores: Vec<Score>,
}

impl SweepPlan {
    /// The sweep of `scene`, which is called `name`, over `x`.
    ///
    /// # Errors
    /// A key that is no number of the scene or of a stabilizer that takes part; a value that is not allowed; a
    /// stabilizer named twice.
    pub fn new(
        name: &str,
        scene: Scene,
        x: Axis,
        members: impl IntoIterator<Item = impl Into<StabilizerName>>,
    ) -> Result<Self, GridError> {
        let stabilizers = StabilizerNames::of(members).map_err(GridError::StabilizerNames)?;
        let variation = Variation::of(&scene, &[&x], &stabilizers)?;
        let at = |index| {
            let value = x.value(index);
            let bare = variation.scene(&[Some(value)])?;
            let bare = bare.map_err(|reason| no_scene(&x, value, &scene, &reason))?;
            let each = stabilizers.iter();
            each.map(|member| variation.under(bare.clone(), *member, &[value])).collect()
        };
        let scenes = (0..x.count).map(at).collect::<Result<_, VaryError>>()?;
        Ok(Self { name: name.to_owned(), scene, x, stabilizers, scenes })
    }

    /// The ticks of all runs.
    pub fn ticks(&self) -> u64 {
        self.scenes.iter().flatten().map(|scene| scene.ticks() + 1).sum()
    }

    /// Runs all on `threads` threads, or as many as there are cores; `watch` learns how many more ticks are done, and says
    /// whether to go on.
    ///
    /// # Errors
    /// [`RunError::Stopped`] if `watch` stops it; a stabilizer that cannot be made; threads that cannot be started.
    pub fn run(self, threads: Option<usize>, watch: &SharedWatch<'_>) -> Result<Sweep, RunError> {
        let pool = threads::pool(threads, self.x.count)?;
        let points = (0..self.x.count).into_par_iter().map(|index| {
            let value = self.x.value(index);
            let each = self.scenes[index as usize].iter().zip(self.stabilizers.iter());
            let scores = each.map(|(scene, member)| {
                compare::score_under(scene, *member, watch).map_err(|reason| match reason {
                    compare::RunError::Stopped => RunError::Stopped,
                    compare::RunError::Parameter(error) => {
                        let cell = format!("`{}` = {value:?}", self.x.key);
                        RunError::Cell(GridError::Refused { cell, stabilizer: *member, error })
                    }
                })
            });
            let mut scores = scores.collect::<Result<Vec<_>, _>>()?;
            compare::mark_broken(&mut scores);
            Ok(Point { value, scores })
        });
        let points = pool.install(|| points.collect::<Result<Vec<_>, RunError>>())?;
        let Self { name, scene, x, stabilizers, .. } = self;
        Ok(Sweep { name, scene, x, stabilizers, points })
    }
}
