//! Corrections of many ticks or loops, as arrays.

use std::collections::TryReserveError;

use pyo3::exceptions::PyMemoryError;
use pyo3::prelude::*;

use super::arrays::array;
use crate::stored;

/// Lack of memory for results.
pub(super) type Scarce = TryReserveError;

/// The error of ticks for whose results there is no memory.
pub(super) fn scarce(ticks: usize, loops: usize) -> PyErr {
    PyMemoryError::new_err(format!(
        "there is no memory for the corrections of {ticks} ticks of {loops} loops; give fewer ticks, in several calls"
    ))
}

/// `count` times `value`.
fn filled<T: Clone>(count: usize, value: T) -> Result<Vec<T>, Scarce> {
    let mut filled = Vec::new();
    filled.try_reserve_exact(count)?;
    filled.resize(count, value);
    Ok(filled)
}

/// Corrections of many ticks or loops: `effort`, N, in the shape of the effort given; `observed_energy`, J, `alpha`, N·s/m,
/// `shortfall`, J, and `accepted`, bool, without its axis of axes.
#[pyclass(module = "lyapunov", frozen, get_all)]
#[derive(Debug)]
pub(crate) struct Corrections {
    effort: Py<PyAny>,
    observed_energy: Py<PyAny>,
    alpha: Py<PyAny>,
    shortfall: Py<PyAny>,
    accepted: Py<PyAny>,
}

#[pymethods]
impl Corrections {
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let (py, it) = (slf.py(), slf.get());
        let arrays = [&it.effort, &it.observed_energy, &it.alpha, &it.shortfall, &it.accepted];
        let [effort, observed_energy, alpha, shortfall, accepted] =
            arrays.map(|array| array.clone_ref(py));
        stored::again(slf, (effort, observed_energy, alpha, shortfall, accepted))
    }

    #[staticmethod]
    fn _restored(
        effort: Py<PyAny>,
        observed_energy: Py<PyAny>,
        alpha: Py<PyAny>,
        shortfall: Py<PyAny>,
        accepted: Py<PyAny>,
    ) -> Self {
        Self { effort, observed_energy, alpha, shortfall, accepted }
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let shape = self.effort.bind(py).getattr("shape")?;
        let accepted = self.accepted.bind(py);
        let (count, all) = (accepted.call_method0("sum")?, accepted.getattr("size")?);
        Ok(format!("<Corrections: efforts of shape {shape}, {count} of {all} accepted>"))
    }
}

/// The same as rows of numbers.
#[derive(Debug)]
pub(super) struct Written {
    pub(super) effort: Vec<f64>,
    pub(super) observed_energy: Vec<f64>,
    pub(super) alpha: Vec<f64>,
    pub(super) shortfall: Vec<f64>,
    pub(super) accepted: Vec<bool>,
}

impl Written {
    /// Room for `count` corrections of `axes` axes.
    pub(super) fn room(count: usize, axes: usize) -> Result<Self, Scarce> {
        Ok(Self {
            effort: filled(count * axes, 0.0)?,
            observed_energy: filled(count, 0.0)?,
            alpha: filled(count, 0.0)?,
            shortfall: filled(count, 0.0)?,
            accepted: filled(count, false)?,
        })
    }

    /// Arrays, the effort's of `shape`.
    pub(super) fn shown(
        self,
        py: Python<'_>,
        shape: &[usize],
        axes: usize,
    ) -> PyResult<Corrections> {
        let each = if axes == 1 { shape } else { &shape[..shape.len() - 1] };
        let numbers = |numbers| array(py, numbers, each).map(|array| array.into_any().unbind());
        Ok(Corrections {
            effort: array(py, self.effort, shape)?.into_any().unbind(),
            observed_energy: numbers(self.observed_energy)?,
            alpha: numbers(self.alpha)?,
            shortfall: numbers(self.shortfall)?,
            accepted: array(py, self.accepted, each)?.into_any().unbind(),
        })
    }
}
