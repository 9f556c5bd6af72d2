//! Study of accuracy against time.

use lyapunov_lab::accuracy::{AccuracyError, Study};
use pyo3::prelude::*;

use super::columns::{Columns, Kinds};
use super::work::{Fault, wait};
use super::{Scene, Told};
use crate::errors;
use crate::number;

/// The columns that do not hold numbers.
const KINDS: Kinds<'_> = Kinds {
    words: &["propagator", "scalar"],
    truths: &["error_is_known", "pareto"],
    wholes: &[],
    judgements: &[],
};

/// Parts of all that progress is told in.
const PARTS: u64 = 1000;

/// What accuracy costs in time.
#[pyfunction]
#[pyo3(signature = (scene, target=None, progress=None))]
pub(crate) fn accuracy(
    py: Python<'_>,
    scene: &Bound<'_, Scene>,
    #[pyo3(from_py_with = number::target_if_any)] target: Option<f64>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Told> {
    let Scene { scene, name } = scene.get().clone();
    if let Some(metres) = target.filter(|metres| !(*metres > 0.0 && metres.is_finite())) {
        return Err(errors::input(format!(
            "target is {metres:?}: an error is a length in m that is greater than 0 and finite\n  = give one, for example 1e-9"
        )));
    }
    wait(py, progress, PARTS, move |watched| {
        let study = Study::watched(&name, &scene, &|share| watched.reach(share));
        let study = study.map_err(|error| match error {
            AccuracyError::Stopped => Fault::Stopped,
            error @ AccuracyError::Space { .. } => Fault::input(error),
            error => Fault::input(format_args!("{name}: {error}")),
        })?;
        let advice =
            target.map_or_else(String::new, |metres| format!("\n{}", study.advice(metres)));
        Ok(Told {
            json: study.to_json(target),
            text: format!("{study}{advice}"),
            figures: vec![study.figure().to_svg()],
            columns: Columns::of_csv(&study.csv(), KINDS)?.into(),
            ..Told::default()
        })
    })
}
