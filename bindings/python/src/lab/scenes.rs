//! The scenes that ship.

use lyapunov_lab::scenes::SCENES;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// The scenes that ship, by their names for `Scene.shipped`: what each shows, and what to look at there.
#[pyfunction]
pub(crate) fn scenes(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    let found = PyDict::new(py);
    SCENES.iter().try_for_each(|scene| found.set_item(scene.name, scene.comment().join("\n")))?;
    Ok(found)
}
