//! Costs of one run.

use super::objective::{Objective, Term};
use super::study::{TuneError, Watch};
use crate::files::Scene;
use crate::measure::Verdict;
use crate::studies::compare::{RunError, score_as_told};

/// The cost of the run of `scene` under the stabilizer of `told`, which knows the numbers of `told` only; none where it
/// grows or cannot be judged.
pub(super) fn cost(
    scene: &Scene,
    told: &Scene,
    objective: &Objective,
    watch: &Watch<'_>,
) -> Result<Option<f64>, TuneError> {
    // Progress is counted in runs.
    let go_on = |_| watch(0);
    let score = score_as_told(scene, told, &go_on).map_err(|error| match error {
        RunError::Stopped => TuneError::Stopped,
        RunError::Parameter(error) => TuneError::Parameter(error),
    })?;
    if watch(1).is_break() {
        return Err(TuneError::Stopped);
    }
    let costs = Term::ALL.map(|term| match term {
        Term::Settling => {
            let settles = score.verdict == Verdict::Settles;
            score.settling_time.filter(|_| settles).unwrap_or(scene.duration.get())
        }
        Term::ForceError => score.force_error.unwrap_or(0.0),
        Term::Stiffness => (100.0 - score.stiffness_percent.unwrap_or(0.0)).max(0.0),
    });
    Ok(score.verdict.is_bounded().then(|| objective.of(costs)))
}
