//! What a study tells, in every form.

use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::columns::Columns;

/// What a study tells: the JSON and the words of the command, figures, and columns.
#[pyclass(module = "lyapunov", frozen)]
#[derive(Debug, Default)]
pub(crate) struct Told {
    /// What the command prints with --json.
    #[pyo3(get)]
    pub(crate) json: String,
    /// What the command prints.
    #[pyo3(get)]
    pub(crate) text: String,
    /// The figures that the command draws with --out, as SVG.
    #[pyo3(get)]
    pub(crate) figures: Vec<String>,
    /// The scenes that come out, as TOML, with a name for each.
    #[pyo3(get)]
    pub(crate) scenes: Vec<(String, String)>,
    pub(crate) columns: Columns,
}

#[pymethods]
impl Told {
    /// The table as a dictionary: numbers as float64 arrays of shape (rows,), words as lists.
    fn columns<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.columns.clone().into_dict(py)
    }
}
