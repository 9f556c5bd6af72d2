//! Correction of a stabilizer.

use lyapunov::Correction as Corrected;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use super::sample::shown;
use crate::axes::{Axes, on_any_axes, whatever_axes, with_axes};
use crate::number;
use crate::stored;
use crate::whole;

on_any_axes! {
    /// A correction, whatever its axes.
    #[derive(Clone, Copy, Debug, PartialEq)]
    enum AnyCorrection of Corrected
}

/// What a stabilizer makes of an effort.
///
/// `Correction(effort, *, observed_energy=0.0, alpha=0.0, shortfall=0.0, accepted=True, axes=1)` makes one by hand, in a
/// stabilizer written in Python. Nobody computes what it leaves out: reports tell these numbers as they are given, and None where
/// nothing was told, as docs/python.md says.
#[pyclass(module = "lyapunov", frozen, eq, skip_from_py_object)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Correction(pub(crate) AnyCorrection);

#[pymethods]
impl Correction {
    #[new]
    #[pyo3(signature = (effort, *, observed_energy=0.0, alpha=0.0, shortfall=0.0, accepted=true, axes=1))]
    fn new(
        effort: &Bound<'_, PyAny>,
        #[pyo3(from_py_with = number::observed_energy)] observed_energy: f64,
        #[pyo3(from_py_with = number::alpha)] alpha: f64,
        #[pyo3(from_py_with = number::shortfall)] shortfall: f64,
        #[pyo3(from_py_with = number::accepted)] accepted: bool,
        #[pyo3(from_py_with = whole::axes)] axes: usize,
    ) -> PyResult<Self> {
        with_axes!(axes, AnyCorrection, V => Corrected {
            effort: V::read(effort, "effort")?,
            observed_energy,
            alpha,
            shortfall,
            accepted,
        })
        .map(Self)
    }

    /// The number of axes.
    #[getter]
    fn axes(&self) -> usize {
        self.0.axes()
    }

    /// The corrected effort, N: a float, or an array of shape (axes,).
    #[getter]
    fn effort<'py>(&self, py: Python<'py>) -> Bound<'py, PyAny> {
        whatever_axes!(&self.0, AnyCorrection, it => it.effort.show(py))
    }

    /// The observed energy before this correction, J; a debt below 0.
    #[getter]
    fn observed_energy(&self) -> f64 {
        whatever_axes!(&self.0, AnyCorrection, it => it.observed_energy)
    }

    /// The injected damping, N·s/m; 0 where the effort is corrected in another way.
    #[getter]
    fn alpha(&self) -> f64 {
        whatever_axes!(&self.0, AnyCorrection, it => it.alpha)
    }

    /// The part of a debt that this tick could not repair, J.
    #[getter]
    fn shortfall(&self) -> f64 {
        whatever_axes!(&self.0, AnyCorrection, it => it.shortfall)
    }

    /// Whether the sample was accepted; the effort is 0 where it was not.
    #[getter]
    fn accepted(&self) -> bool {
        whatever_axes!(&self.0, AnyCorrection, it => it.accepted)
    }

    fn __copy__(slf: Py<Self>) -> Py<Self> {
        // It never changes.
        slf
    }

    fn __deepcopy__(slf: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
        slf
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let (py, it) = (slf.py(), slf.get());
        let bytes = whatever_axes!(&it.0, AnyCorrection, it => stored::write(it)?);
        stored::again(slf, (it.axes(), PyBytes::new(py, &bytes)))
    }

    #[staticmethod]
    fn _restored(axes: usize, bytes: &[u8]) -> PyResult<Self> {
        with_axes!(axes, AnyCorrection, V => stored::read::<Corrected<V>>(bytes)?).map(Self)
    }

    #[pyo3(name = "__repr__")]
    pub(super) fn told(&self) -> String {
        whatever_axes!(&self.0, AnyCorrection, it => format!(
            "Correction(effort={}, observed_energy={:?}, alpha={:?}, shortfall={:?}, accepted={}{})",
            shown(&it.effort),
            it.observed_energy,
            it.alpha,
            it.shortfall,
            if it.accepted { "True" } else { "False" },
            if self.axes() > 1 { format!(", axes={}", self.axes()) } else { String::new() },
        ))
    }
}
