//! Stabilizer written in Python.

use lyapunov::{Correction as Corrected, PortSample, Stabilizer};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyType;

use super::sample::accepted;
use super::{Correction, Raised, Sample, Stabilizer as Block, seen};
use crate::axes::Axes;

/// An object with a method `stabilize(sample, effort)` that returns a `Correction`.
#[derive(Debug)]
pub(crate) struct PythonStabilizer {
    object: Py<PyAny>,
    raised: Raised,
}

impl PythonStabilizer {
    /// The stabilizer of `object`, of a block a fresh one; what it raises is kept in `raised`.
    pub(crate) fn of(object: &Bound<'_, PyAny>, raised: Raised) -> PyResult<Self> {
        let object = match object.cast::<Block>() {
            Ok(block) => Bound::new(object.py(), seen(block)?.fresh(object.py())?)?.into_any(),
            Err(_) => object.clone(),
        };
        Ok(Self { object: object.unbind(), raised })
    }

    /// One that is asked for nothing, as `raised` holds an error.
    pub(crate) fn none(py: Python<'_>, raised: Raised) -> Self {
        Self { object: py.None(), raised }
    }

    /// Checks that `object`, called `name` there, has the method.
    pub(crate) fn check(object: &Bound<'_, PyAny>, name: &str) -> PyResult<()> {
        if let Ok(class) = object.cast::<PyType>() {
            return Err(PyTypeError::new_err(format!(
                "{name} is the class {}; give an object of it",
                class.name()?
            )));
        }
        if object.hasattr("stabilize")? {
            return Ok(());
        }
        Err(PyTypeError::new_err(format!(
            "{name} is {}; give a name of docs/family.md, or an object with a method stabilize(sample, effort)",
            object.get_type().name()?
        )))
    }

    fn asked<V: Axes>(&self, sample: &PortSample<V>, effort: V) -> PyResult<Corrected<V>> {
        Python::attach(|py| {
            let sample = Sample(V::sample(accepted(*sample)));
            let told = self.object.call_method1(py, "stabilize", (sample, effort.show(py)))?;
            let told = told.bind(py);
            let Ok(correction) = told.cast::<Correction>() else {
                return Err(PyTypeError::new_err(format!(
                    "stabilize(sample, effort) returned {}; return a Correction",
                    told.get_type().name()?
                )));
            };
            let made = V::of_correction(&correction.get().0).copied()?;
            let is_number = (0..V::COUNT).all(|axis| !made.effort.along(axis).is_nan());
            is_number.then_some(made).ok_or_else(|| {
                PyValueError::new_err(format!(
                    "stabilize(sample, effort) returned {}, whose effort is not a number",
                    correction.get().told()
                ))
            })
        })
    }
}

impl<V: Axes> Stabilizer<V> for PythonStabilizer {
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Corrected<V> {
        // Not a number ends the run.
        let rejected =
            Corrected { observed_energy: f64::NAN, accepted: false, ..Corrected::none(effort) };
        if self.raised.is_kept() {
            return rejected;
        }
        self.asked(sample, effort).unwrap_or_else(|error| {
            self.raised.keep(error);
            rejected
        })
    }
}
