//! What a study tells, in every form.

use std::mem;
use std::sync::{Mutex, PoisonError};

use pyo3::prelude::*;
use pyo3::sync::MutexExt;
use pyo3::types::PyDict;

use super::columns::Columns;
use crate::stored;
use crate::words;

/// What a study tells: the JSON and the words of the command, figures, and columns.
#[pyclass(module = "lyapunov._lyapunov", frozen)]
#[derive(Debug, Default)]
pub(crate) struct Told {
    /// The output of the command with --json.
    #[pyo3(get)]
    pub(crate) json: String,
    /// The output of the command, in its own words.
    pub(crate) text: String,
    /// The figures that the command draws with --out, as SVG.
    #[pyo3(get)]
    pub(crate) figures: Vec<String>,
    /// The scenes that come out, as TOML, with a name for each.
    #[pyo3(get)]
    pub(crate) scenes: Vec<(String, String)>,
    pub(crate) columns: Held,
    /// A second table, as that of stabilizers on a recorded log.
    pub(crate) further: Held,
}

/// Columns, which become arrays of NumPy when they are first asked for.
#[derive(Debug)]
pub(crate) struct Held(Mutex<Kept>);

#[derive(Debug)]
enum Kept {
    Made(Columns),
    Shown(Py<PyDict>),
}

impl From<Columns> for Held {
    fn from(columns: Columns) -> Self {
        Self(Mutex::new(Kept::Made(columns)))
    }
}

impl Default for Held {
    fn default() -> Self {
        Columns::default().into()
    }
}

impl Held {
    /// The table; its arrays are made once, and not copied.
    fn shown<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let mut kept = self.0.lock_py_attached(py).unwrap_or_else(PoisonError::into_inner);
        let table = match mem::replace(&mut *kept, Kept::Made(Columns::default())) {
            Kept::Made(columns) => columns.into_dict(py)?,
            Kept::Shown(table) => table.into_bound(py),
        };
        *kept = Kept::Shown(table.clone().unbind());
        table.copy()
    }
}

#[pymethods]
impl Told {
    /// The output of the command, in the words of Python.
    #[getter]
    fn text(&self) -> String {
        words::of_python(&self.text)
    }

    /// The table as a dictionary: numbers as float64 arrays of shape (rows,), whole ones as int64, truths as bool, words and truths
    /// that may be unknown as lists. Every call gives the same arrays.
    fn columns<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.columns.shown(py)
    }

    /// A second table of the same form; empty where there is none.
    fn further<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.further.shown(py)
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let (py, Self { json, text, figures, scenes, columns, further }) = (slf.py(), slf.get());
        let tables = (columns.shown(py)?, further.shown(py)?);
        stored::again(slf, (json, text, figures, scenes.clone(), tables))
    }

    #[staticmethod]
    fn _restored(
        json: String,
        text: String,
        figures: Vec<String>,
        scenes: Vec<(String, String)>,
        tables: (Py<PyDict>, Py<PyDict>),
    ) -> Self {
        let [columns, further] = [tables.0, tables.1].map(|it| Held(Mutex::new(Kept::Shown(it))));
        Self { json, text, figures, scenes, columns, further }
    }
}
