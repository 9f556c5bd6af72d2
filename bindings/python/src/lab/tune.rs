//! Tuning of stabilizers.

use lyapunov_lab::family::StabilizerNames;
use lyapunov_lab::tune::{Objective, TuneError, Tuning, csv, document, figure, table};
use pyo3::prelude::*;

use super::columns::{Columns, Kinds};
use super::work::{Fault, wait};
use super::{Scene, Told};
use crate::errors;
use crate::whole;

/// The columns that do not hold numbers.
const KINDS: Kinds<'_> =
    Kinds { words: &["stabilizer", "key", "unit"], truths: &[], wholes: &[], judgements: &[] };

/// The best parameters of each stabilizer, from as many runs for each.
#[pyfunction]
#[pyo3(signature = (scene, stabilizers, objective=None, trials=None, runs=None, seed=None, progress=None))]
#[allow(clippy::too_many_arguments)]
pub(crate) fn tune(
    py: Python<'_>,
    scene: &Bound<'_, Scene>,
    stabilizers: &str,
    objective: Option<&str>,
    #[pyo3(from_py_with = whole::trials_if_any)] trials: Option<u32>,
    #[pyo3(from_py_with = whole::runs_if_any)] runs: Option<u32>,
    #[pyo3(from_py_with = whole::seed_if_any)] seed: Option<u64>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Told> {
    let Scene { scene, name } = scene.get().clone();
    let names: StabilizerNames = stabilizers.parse().map_err(errors::input)?;
    let names = names.on(&scene);
    let usual = Tuning::default();
    let objective = objective.map_or(Ok(usual.objective), str::parse::<Objective>);
    let tuning = Tuning {
        objective: objective.map_err(errors::input)?,
        trials: within(trials.unwrap_or(usual.trials), 1, "trials")?,
        runs: within(runs.unwrap_or(usual.runs), 2, "runs")?,
        seed: seed.unwrap_or(usual.seed),
        ..usual
    };
    Tuning::check(&names, &scene).map_err(|error| errors::input(format!("{name}: {error}")))?;
    wait(py, progress, names.len() as u64 * tuning.rollouts(), move |watched| {
        let tuned = names.iter().map(|who| {
            tuning.of(&scene, *who, &|runs| watched.add(runs)).map_err(|error| match error {
                TuneError::Stopped => Fault::Stopped,
                error => Fault::input(format_args!("{name}: {error}")),
            })
        });
        let tuned = tuned.collect::<Result<Vec<_>, _>>()?;
        let scenes = tuned.iter().map(|one| {
            one.text().map(|text| (one.name.to_string(), text)).map_err(Fault::internal)
        });
        Ok(Told {
            json: document(&name, &tuning, &tuned),
            text: table(&name, &tuning, &tuned),
            figures: vec![figure(&name, tuning.objective, &tuned).to_svg()],
            scenes: scenes.collect::<Result<_, _>>()?,
            columns: Columns::of_csv(&csv(&tuned), KINDS)?.into(),
            ..Told::default()
        })
    })
}

/// A number of runs in the range that the command takes.
fn within(number: u32, least: u32, name: &str) -> PyResult<u32> {
    match (least..=100_000).contains(&number) {
        true => Ok(number),
        false => {
            Err(errors::input(format!("{name} is {number}; it must be from {least} to 100000")))
        }
    }
}
