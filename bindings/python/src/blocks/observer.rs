//! Observer of a candidate.

use lyapunov::Observer as Observing;
use pyo3::prelude::*;

use super::{Candidate, Raised, Recipe, Sample};
use crate::axes::{Axes, whatever_axes};
use crate::blocks::AnySample;

type Inner = Observing<Candidate, lyapunov::Held, lyapunov::accumulators::Plain<f64>>;

/// Observed energy of a candidate, without a controller.
///
/// `Observer(damping=0.0)` watches the port's energy with the credit of a damper of `damping` N·s/m that the device
/// surely has; `Observer(candidate=it)` asks `it.decrease(sample)`, in joules, a method written in Python: slow.
#[pyclass(module = "lyapunov")]
#[derive(Debug)]
pub(crate) struct Observer {
    observer: Inner,
    energy: f64,
    raised: Raised,
}

#[pymethods]
impl Observer {
    #[new]
    #[pyo3(signature = (*, damping=None, candidate=None))]
    fn new(damping: Option<f64>, candidate: Option<Py<PyAny>>) -> PyResult<Self> {
        let raised = Raised::default();
        let candidate = Recipe::candidate(damping, candidate, &raised)?;
        Ok(Self { observer: Observing::of(candidate), energy: 0.0, raised })
    }

    /// Books the candidate's decrease over the sample; returns the observed energy, J.
    fn observe(&mut self, sample: &Sample) -> PyResult<f64> {
        self.energy =
            whatever_axes!(&sample.0, AnySample, it => observed(&mut self.observer, &it.sample));
        self.raised.check()?;
        Ok(self.energy)
    }

    /// The observed energy, J.
    #[getter]
    fn observed_energy(&self) -> f64 {
        self.energy
    }

    fn __repr__(&self) -> String {
        format!("Observer(observed_energy={:?})", self.energy)
    }
}

fn observed<V: Axes>(observer: &mut Inner, sample: &lyapunov::PortSample<V>) -> f64 {
    observer.observe(sample, V::zero())
}
