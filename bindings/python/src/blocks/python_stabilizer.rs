//! Stabilizer written in Python.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use lyapunov::{Correction as Corrected, PortSample, Stabilizer};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;

use super::sample::checked;
use super::{Correction, Raised, Sample, Stabilizer as Block, seen};
use crate::axes::Axes;
use crate::errors;

/// An object with a method `stabilize(sample, effort)` that returns a `Correction`.
#[derive(Debug)]
pub(crate) struct PythonStabilizer {
    object: Option<Py<PyAny>>,
    run: Asker,
}

/// The work that asks a stabilizer written in Python.
#[derive(Clone, Debug)]
pub(crate) struct Asker {
    /// The stabilizer and its scene, for whoever reads an error.
    pub(crate) about: Arc<str>,
    /// The errors that they raised.
    pub(crate) raised: Raised,
    /// Whether the work was interrupted.
    pub(crate) stopped: Arc<AtomicBool>,
}

impl Asker {
    /// Whether nothing is asked any more: work looks for an interrupt only now and then, and would otherwise call stabilizers
    /// after it.
    pub(crate) fn is_over(&self) -> bool {
        self.stopped.load(Ordering::Relaxed) || self.raised.is_kept()
    }

    /// Keeps an error, with a note of where it was raised.
    pub(crate) fn keep(&self, error: PyErr) {
        let note = format!("raised by {}", self.about);
        // Python 3.10 has no notes.
        let _ = Python::try_attach(|py| error.value(py).call_method1("add_note", (note,)).is_ok());
        self.raised.keep(error);
    }
}

impl PythonStabilizer {
    /// The stabilizer that asks `object`, or a fresh copy if that is a block, during `run`.
    pub(crate) fn of(object: &Bound<'_, PyAny>, run: Asker) -> PyResult<Self> {
        let object = match object.cast::<Block>() {
            Ok(block) => Bound::new(object.py(), seen(block)?.fresh(object.py())?)?.into_any(),
            Err(_) => object.clone(),
        };
        Ok(Self { object: Some(object.unbind()), run })
    }

    /// A stabilizer without an object, for a `run` that is over: it rejects every sample.
    pub(crate) fn none(run: Asker) -> Self {
        Self { object: None, run }
    }

    /// Checks that `object`, called `name` there, has the method.
    pub(crate) fn check(object: &Bound<'_, PyAny>, name: &str) -> PyResult<()> {
        let remedy =
            "a name of docs/family.md, or an object with a method stabilize(sample, effort)";
        errors::with_method(object, name, "stabilize", remedy)
    }

    fn asked<V: Axes>(
        py: Python<'_>,
        object: &Py<PyAny>,
        sample: &PortSample<V>,
        effort: V,
    ) -> PyResult<Corrected<V>> {
        let sample = Sample(V::sample(checked(*sample)));
        let told = object.call_method1(py, "stabilize", (sample, effort.show(py)))?;
        let told = told.bind(py);
        let Ok(correction) = told.cast::<Correction>() else {
            return Err(PyTypeError::new_err(format!(
                "stabilize(sample, effort) returned {}; return a Correction",
                told.get_type().name()?
            )));
        };
        let made = V::of_correction(&correction.get().0).copied()?;
        let has_effort = (0..V::COUNT).all(|axis| !made.effort.along(axis).is_nan());
        let tells =
            [made.observed_energy, made.alpha, made.shortfall].iter().all(|it| it.is_finite());
        let what = match (has_effort, tells || !made.accepted) {
            (true, true) => return Ok(made),
            (false, _) => "whose effort is not a number",
            (true, false) => {
                "whose energies and damping are not all finite; say accepted=False of a sample of no use"
            }
        };
        let told = correction.get().told();
        Err(PyValueError::new_err(format!("stabilize(sample, effort) returned {told}, {what}")))
    }
}

impl<V: Axes> Stabilizer<V> for PythonStabilizer {
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Corrected<V> {
        // Not a number ends the run.
        let rejected =
            Corrected { observed_energy: f64::NAN, accepted: false, ..Corrected::none(effort) };
        let Some(object) = self.object.as_ref().filter(|_| !self.run.is_over()) else {
            return rejected;
        };
        // An interpreter that ends cannot be asked.
        match Python::try_attach(|py| Self::asked(py, object, sample, effort)) {
            Some(Ok(made)) => made,
            Some(Err(error)) => {
                self.run.keep(error);
                rejected
            }
            None => rejected,
        }
    }
}
