//! Observer of a candidate.

use std::sync::Arc;

use lyapunov::{Observer as Observing, Snapshot};
use pyo3::gc::{PyTraverseError, PyVisit};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};

use super::deep_copy::{Asking, deep_copy};
use super::{AnySample, Candidate, Raised, Recipe, Sample, seen, taken};
use crate::axes::{Axes, whatever_axes};
use crate::errors::{self, of_class};
use crate::number;
use crate::stored;

type Inner = Observing<Candidate, lyapunov::Held, lyapunov::accumulators::Plain<f64>>;

/// Observed energy of a candidate, without a controller.
///
/// `Observer(damping=0.0)` watches the port's energy with the credit of a damper of `damping` N·s/m that the device
/// surely has; `Observer(candidate=it)` asks `it.decrease(sample)`, in joules, `sample.work` and what is
/// credited besides, a method written in Python: slow.
#[pyclass(module = "lyapunov")]
#[derive(Debug)]
pub(crate) struct Observer {
    observer: Inner,
    energy: f64,
    raised: Raised,
    /// The damping and the object that it was made with.
    damping: Option<f64>,
    object: Option<Arc<Py<PyAny>>>,
}

#[pymethods]
impl Observer {
    #[new]
    #[pyo3(signature = (*, damping=None, candidate=None))]
    fn new(
        #[pyo3(from_py_with = number::damping_if_any)] damping: Option<f64>,
        candidate: Option<Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let candidate = candidate.map(Candidate::checked).transpose()?;
        Self::of(damping, candidate)
    }

    /// Books the candidate's decrease over the sample; returns the observed energy, J.
    fn observe(slf: &Bound<'_, Self>, sample: &Bound<'_, PyAny>) -> PyResult<f64> {
        let sample: &Sample = of_class(sample, "sample")?.get();
        let this = &mut *taken(slf)?;
        this.energy =
            whatever_axes!(&sample.0, AnySample, it => observed(&mut this.observer, &it.sample));
        this.raised.check()?;
        Ok(this.energy)
    }

    /// The observed energy, J.
    #[getter]
    fn observed_energy(slf: &Bound<'_, Self>) -> PyResult<f64> {
        Ok(seen(slf)?.energy)
    }

    /// A copy with the same memory.
    fn __copy__(slf: &Bound<'_, Self>) -> PyResult<Self> {
        seen(slf)?.copied(slf.py())
    }

    fn __deepcopy__<'py>(
        slf: &Bound<'py, Self>,
        memo: &Bound<'py, PyDict>,
    ) -> PyResult<Bound<'py, Self>> {
        deep_copy(slf, memo)
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let (py, this) = (slf.py(), seen(slf)?);
        let memory = PyBytes::new(py, &this.memory()?);
        let object = this.object.as_ref().map(|object| object.clone_ref(py));
        let parts = (this.damping, object, this.energy, memory);
        stored::again(slf, parts)
    }

    #[staticmethod]
    fn _restored(
        damping: Option<f64>,
        candidate: Option<Py<PyAny>>,
        energy: f64,
        memory: &[u8],
    ) -> PyResult<Self> {
        Self::of(damping, candidate)?.remembering(energy, memory)
    }

    fn __traverse__(&self, visit: PyVisit<'_>) -> Result<(), PyTraverseError> {
        visit.call(self.object.as_deref())
    }

    fn __clear__(&mut self) {
        // Two fields hold the candidate, which may hold this observer: both let it go.
        let none = Self::of(None, None).expect("an observer without a candidate");
        *self = Self { energy: self.energy, ..none };
    }

    fn __repr__(slf: &Bound<'_, Self>) -> PyResult<String> {
        Ok(format!("Observer(observed_energy={:?})", seen(slf)?.energy))
    }
}

impl Asking for Observer {
    fn copied(&self, py: Python<'_>) -> PyResult<Self> {
        let object = self.object.as_ref().map(|object| object.clone_ref(py));
        Self::of(self.damping, object)?.remembering(self.energy, &self.memory()?)
    }

    fn asked(&self) -> Option<&Py<PyAny>> {
        self.object.as_deref()
    }

    fn ask(&mut self, candidate: Py<PyAny>) -> PyResult<()> {
        let memory = self.memory()?;
        *self = Self::of(self.damping, Some(candidate))?.remembering(self.energy, &memory)?;
        Ok(())
    }
}

impl Observer {
    fn of(damping: Option<f64>, object: Option<Py<PyAny>>) -> PyResult<Self> {
        let (raised, object) = (Raised::default(), object.map(Arc::new));
        let candidate = Recipe::candidate(damping, object.clone(), &raised)?;
        Ok(Self { observer: Observing::of(candidate), energy: 0.0, raised, damping, object })
    }

    /// The memory as bytes that keep every bit.
    fn memory(&self) -> PyResult<Vec<u8>> {
        stored::write(&self.observer.state())
    }

    /// The same with the memory of another one.
    fn remembering(self, energy: f64, memory: &[u8]) -> PyResult<Self> {
        let observer = self.observer.restored(stored::read(memory)?).map_err(errors::parameter)?;
        Ok(Self { observer, energy, ..self })
    }
}

fn observed<V: Axes>(observer: &mut Inner, sample: &lyapunov::PortSample<V>) -> f64 {
    observer.observe(sample, V::zero())
}
