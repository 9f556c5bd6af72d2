//! Comparison of all entrants on one scene.

use std::fmt;
use std::ops::ControlFlow;
use std::panic::resume_unwind;
use std::thread;

use lyapunov::ParameterError;

use super::column::Column;
use super::compared::RunError;
use super::entrant_run::{Curves, EntrantRun, Watch};
use super::entrants::Entrants;
use super::score::Score;
use super::{broken, cost, picture, table};
use crate::files::Scene;
use crate::files::scene::{Conflict, Scalar};
use crate::measure::Oddity;
use crate::simulate::Space;
use crate::simulate::family::Settings;
use lyapunov_figures::Figure;

/// All entrants on one scene; its `Display` is the table of `lyapunov compare`.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// The scene's name, usually the path of its file.
    pub name: String,
    /// The scene.
    pub scene: Scene,
    /// The settings of POPC and LOLC.
    pub settings: Settings,
    pub(super) outcomes: Vec<Outcome>,
}

/// Result of one entrant.
#[derive(Clone, Debug)]
pub(super) struct Outcome {
    /// Its place in the order of registration.
    pub(super) number: usize,
    pub(super) score: Score,
    pub(super) curves: Curves,
    /// The signs of a mistake in its run.
    pub(super) look_at: Vec<Oddity>,
}

/// Reason why there is no comparison.
#[derive(Clone, Debug, PartialEq)]
pub enum CompareError {
    /// A stabilizer or the loop about it cannot be made on a scene.
    Parameter {
        /// The entrant.
        stabilizer: String,
        /// The scene.
        scene: String,
        /// The parameter's error.
        error: ParameterError,
        /// The scalar that the scene names: another range may be the remedy.
        scalar: Scalar,
    },
    /// A stabilizer for one dimension on a scene in a space.
    Axes {
        /// The scene.
        scene: String,
        /// The reason.
        conflict: Conflict,
    },
    /// `watch` stopped the runs.
    Stopped,
}

impl CompareError {
    /// The error for the `reason` why `stabilizer` does not run on `scene`, which is called `name`.
    pub(super) fn of(
        reason: impl Into<RunError>,
        stabilizer: &str,
        name: &str,
        scene: &Scene,
    ) -> Self {
        match reason.into() {
            RunError::Stopped => Self::Stopped,
            RunError::Parameter(error) => Self::Parameter {
                stabilizer: stabilizer.to_owned(),
                scene: name.to_owned(),
                error,
                scalar: scene.scalar,
            },
        }
    }
}

impl fmt::Display for CompareError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Parameter { stabilizer, scene, error, scalar } => {
                write!(f, "{scene}: {stabilizer} cannot run here: {error}\n  = ")?;
                match scalar {
                    Scalar::F32 => write!(
                        f,
                        "change that value in the scene, leave {stabilizer} out, or compute in f64 if only f32 cannot hold it"
                    ),
                    Scalar::F64 => {
                        write!(f, "change that value in the scene, or leave {stabilizer} out")
                    }
                }
            }
            Self::Axes { scene, conflict } => {
                write!(f, "{scene}: {}\n  = {}", conflict.problem(), conflict.remedy())
            }
            Self::Stopped => f.write_str("the comparison was stopped"),
        }
    }
}

impl std::error::Error for CompareError {}

impl Comparison {
    /// Runs all `entrants` on `scene` in the scalar of `V`, whatever scalar `scene` names, and times their steps.
    ///
    /// # Errors
    /// A stabilizer that cannot be made on this scene, or is for one dimension only.
    pub fn of<V: Space>(
        name: &str,
        scene: &Scene,
        entrants: &Entrants<V>,
    ) -> Result<Self, CompareError> {
        Self::watched(name, scene, entrants, &|_| ControlFlow::Continue(()))
    }

    /// Runs the comparison of [`Comparison::of`], reporting to `watch` from time to time how many more ticks are done;
    /// `watch` says whether to go on.
    ///
    /// # Errors
    /// Those of [`Comparison::of`], and [`CompareError::Stopped`] if `watch` stops the runs.
    pub fn watched<V: Space>(
        name: &str,
        scene: &Scene,
        entrants: &Entrants<V>,
        watch: &(dyn Fn(u64) -> ControlFlow<()> + Sync),
    ) -> Result<Self, CompareError> {
        let mut named = entrants.entries().iter().filter_map(|entrant| entrant.like);
        named
            .try_for_each(|like| like.check_axes(scene))
            .map_err(|conflict| CompareError::Axes { scene: name.to_owned(), conflict })?;
        let runs = runs(scene, entrants, watch);
        let (mut scores, mut shown, mut samples) = (Vec::new(), Vec::new(), Vec::new());
        for (run, entry) in runs.into_iter().zip(entrants.names()) {
            let run = run.map_err(|reason| CompareError::of(reason, entry, name, scene))?;
            scores.push(run.score);
            shown.push((run.curves, run.look_at));
            samples.push(run.samples);
        }
        // By now nothing else runs here.
        let times = cost::of(scene, entrants.entries(), &samples, watch)
            .map_err(|error| CompareError::of(error, "a stabilizer", name, scene))?;
        for (score, time) in scores.iter_mut().zip(times) {
            score.step_time = time;
        }
        broken::mark(&mut scores);
        let outcomes = scores.into_iter().zip(shown).enumerate();
        let outcomes = outcomes.map(|(number, (score, (curves, look_at)))| Outcome {
            number,
            score,
            curves,
            look_at,
        });
        let settings = Settings::of(scene);
        let (name, scene) = (name.to_owned(), scene.clone());
        Ok(Self { name, scene, settings, outcomes: outcomes.collect() })
    }

    /// The score of each entrant.
    pub fn scores(&self) -> impl Iterator<Item = &Score> {
        self.outcomes.iter().map(|outcome| &outcome.score)
    }

    /// Sorts the entrants by a column, smallest first (names alphabetically, verdicts from best to worst), entrants without
    /// a value last, ties in the order of registration.
    pub fn sort_by(&mut self, column: Column) {
        self.outcomes.sort_by(|one, other| {
            column.order(&one.score, &other.score).then(one.number.cmp(&other.number))
        });
    }

    /// Position and observed energy of all entrants, overlaid.
    pub fn figure(&self) -> Figure {
        picture::of(self)
    }

    /// The forces on the plant of all entrants, overlaid.
    pub fn forces(&self) -> Figure {
        picture::forces(self)
    }
}

impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        table::write(self, f)
    }
}

/// Runs one thread per entrant: runs are independent, and the system shares out the cores.
fn runs<V: Space>(
    scene: &Scene,
    entrants: &Entrants<V>,
    watch: &Watch<'_>,
) -> Vec<Result<EntrantRun<V>, RunError>> {
    thread::scope(|scope| {
        let started: Vec<_> = entrants
            .entries()
            .iter()
            .map(|entrant| scope.spawn(move || EntrantRun::of(scene, entrant, watch)))
            .collect();
        // If a user's stabilizer panics, the panic resumes here.
        let joined = started.into_iter().map(|run| run.join());
        joined.map(|run| run.unwrap_or_else(|panic| resume_unwind(panic))).collect()
    })
}
