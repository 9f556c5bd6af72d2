//! Explanation of a run.

use lyapunov_lab::explain::Explanation;
use lyapunov_lab::in_space;
use pyo3::prelude::*;

use super::columns::{Columns, Kinds};
use super::work::{Fault, wait};
use super::{Scene, Told};

/// The columns that do not hold numbers.
const KINDS: Kinds<'_> =
    Kinds { words: &["stretch", "part"], truths: &[], wholes: &[], judgements: &[] };

/// Where the energy of a run comes from, and what helps.
#[pyfunction]
pub(crate) fn explain(py: Python<'_>, scene: &Bound<'_, Scene>) -> PyResult<Told> {
    let Scene { scene, name } = scene.get().clone();
    wait(py, None, 1, move |watched| {
        let watch = |_| watched.go_on();
        let explanation = in_space!(scene, Axes => Explanation::watched::<Axes>(&scene, &watch));
        let explanation =
            explanation.map_err(|error| Fault::input(format_args!("{name}: {error}")))?;
        let explanation = explanation.ok_or(Fault::Stopped)?;
        Ok(Told {
            json: explanation.to_json(&name),
            text: format!("{name}\n{explanation}"),
            figures: vec![explanation.figure(&name).to_svg()],
            columns: Columns::of_csv(&explanation.csv(), KINDS)?.into(),
            ..Told::default()
        })
    })
}
