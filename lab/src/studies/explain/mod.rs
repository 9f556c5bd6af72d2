//! Reasons why a run settles, swings or grows, in words and in joules: `lyapunov explain`.

mod document;
mod goal;
mod groups;
mod hint;
mod picture;
mod remedy;
mod report;
mod words;

use std::ops::ControlFlow;

use lyapunov::ParameterError;

use crate::files::Scene;
use crate::measure::{Limits, Oddity, Verdict, Yardstick};
use crate::simulate::{Criterion, Rollout, Space};

use crate::measure::balance::Trial;
pub use crate::measure::{Balance, Watch};
pub use groups::DimensionlessGroups;
pub use hint::Hint;
pub(crate) use hint::{NEXT, in_balance};
pub use remedy::{Change, Remedy};
use remedy::{Run, Search};

/// Reasons why the run of a scene settles, swings or grows; its `Display` is the output of `lyapunov explain`.
#[derive(Clone, Debug, PartialEq)]
pub struct Explanation {
    /// The scene.
    pub scene: Scene,
    /// The verdict on its run.
    pub verdict: Verdict,
    /// The quantity that its run is judged by.
    pub verdict_by: Yardstick,
    /// Whether the run left the range of the numbers.
    pub left_range: bool,
    /// Whether the run starts in balance and never leaves its band, so that it says nothing about the loop.
    pub is_undisturbed: bool,
    /// The limits of its stiffness, by formula.
    pub limits: Limits,
    /// The dimensionless groups that it depends on.
    pub groups: DimensionlessGroups,
    /// The energies of the first contact, if there is one.
    pub first_contact: Option<Balance>,
    /// The energies of the whole run, or of as much of it as stays in the range of the numbers.
    pub whole_run: Balance,
    /// The largest force on the plant, N.
    pub peak_force: f64,
    /// Root mean square of the force on the plant minus that of the environment's own law, in contact, N; none without a
    /// contact with a wall or a solid.
    pub force_error: Option<f64>,
    /// The remedies, each tried; none where none is needed, and where no force acts.
    pub remedies: Vec<Remedy>,
    /// The signs of a mistake in the scene or its run.
    pub look_at: Vec<Oddity>,
}

impl Explanation {
    /// Runs `scene` in the scalar of `V`, whatever scalar `scene` names, and every remedy that is found.
    ///
    /// # Errors
    /// A loop that cannot be made.
    pub fn of<V: Space>(scene: &Scene) -> Result<Self, ParameterError> {
        Self::along::<V>(scene, &|_| ControlFlow::Continue(()))
    }

    /// The same; `watch` learns from time to time how many more ticks are done. None where it breaks, and soon.
    ///
    /// # Errors
    /// A loop that cannot be made.
    pub fn watched<V: Space>(
        scene: &Scene,
        watch: &Watch<'_>,
    ) -> Result<Option<Self>, ParameterError> {
        let explanation = Self::along::<V>(scene, watch)?;
        Ok(watch(0).is_continue().then_some(explanation))
    }

    /// The same, of what ran until `watch` broke.
    fn along<V: Space>(scene: &Scene, watch: &Watch<'_>) -> Result<Self, ParameterError> {
        let trial = Trial::along(scene, Rollout::<V>::of(scene)?, watch)?;
        Ok(Self::told(scene, trial, Trial::that_holds::<V>, watch))
    }

    /// The explanation of `trial`, a run of `scene`, with the remedies among further runs.
    fn told(scene: &Scene, trial: Trial, run: Run, watch: &Watch<'_>) -> Self {
        let limits = Limits::of(scene);
        let outside = scene.stabilizer.and_then(|own| Oddity::outside(scene, own));
        let look_at = trial.look_at.into_iter().chain(outside).collect();
        let explanation = Self {
            scene: scene.clone(),
            verdict: trial.verdict,
            verdict_by: trial.verdict_by,
            left_range: trial.left_range,
            is_undisturbed: trial.is_undisturbed,
            limits,
            groups: DimensionlessGroups::of(scene),
            first_contact: trial.first,
            whole_run: trial.whole,
            peak_force: trial.feel.peak,
            force_error: trial.feel.error,
            remedies: Vec::new(),
            look_at,
        };
        let own = trial.moved;
        let is_long = Criterion::of(scene).shortage.is_none();
        let goal = explanation.goal().filter(|_| is_long);
        let search = goal.map(|goal| Search { goal, own, run, watch });
        let remedies = search.map_or_else(Vec::new, |it| it.remedies(scene));
        Self { remedies, ..explanation }
    }
}
