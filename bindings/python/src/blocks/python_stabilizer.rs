//! Stabilizer written in Python.

use lyapunov::{Correction as Corrected, PortSample, Stabilizer};
use pyo3::prelude::*;

use super::sample::accepted;
use super::{Correction, Raised, Sample};
use crate::axes::Axes;

/// An object with a method `stabilize(sample, effort)` that returns a `Correction`.
#[derive(Debug)]
pub(crate) struct PythonStabilizer {
    object: Py<PyAny>,
    raised: Raised,
}

impl PythonStabilizer {
    /// The stabilizer of `object`; what it raises is kept in `raised`.
    pub(crate) fn new(object: Py<PyAny>, raised: Raised) -> Self {
        Self { object, raised }
    }

    fn asked<V: Axes>(&self, sample: &PortSample<V>, effort: V) -> PyResult<Corrected<V>> {
        Python::attach(|py| {
            let sample = Sample(V::sample(accepted(*sample)));
            let told = self.object.call_method1(py, "stabilize", (sample, effort.show(py)))?;
            let told = told.bind(py).cast::<Correction>()?.get();
            V::of_correction(&told.0).copied()
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
