//! Corrections of many ticks or loops, as arrays.

use pyo3::prelude::*;

use super::arrays::array;

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
    pub(super) fn room(count: usize, axes: usize) -> Self {
        let zeros = || vec![0.0; count];
        Self {
            effort: vec![0.0; count * axes],
            observed_energy: zeros(),
            alpha: zeros(),
            shortfall: zeros(),
            accepted: vec![false; count],
        }
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
