//! Limits of a scene's stiffness.

use lyapunov_lab::bound::{Limits, RadiusCurve};
use pyo3::prelude::*;

use super::columns::{Columns, Kinds};
use super::work::wait;
use super::{Scene, Told};

/// How stiff the environment may be, by formula and exactly.
#[pyfunction]
pub(crate) fn bound(py: Python<'_>, scene: &Bound<'_, Scene>) -> PyResult<Told> {
    let Scene { scene, name } = scene.get().clone();
    wait(py, None, 1, move |_| {
        let limits = Limits::of(&scene);
        let curve = RadiusCurve::of(&scene, &limits);
        let columns = curve.as_ref().map(|curve| Columns::of_csv(&curve.csv(), Kinds::default()));
        Ok(Told {
            json: limits.to_json(&name),
            text: format!("{name}\n{limits}"),
            figures: curve.iter().map(|curve| curve.figure(&name).to_svg()).collect(),
            columns: columns.transpose()?.unwrap_or_default().into(),
            ..Told::default()
        })
    })
}
