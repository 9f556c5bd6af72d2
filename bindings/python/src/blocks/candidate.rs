//! Candidate of an observer: the port's energy, with a damper credited, or one written in Python.

use lyapunov::{
    CheckedSample, Dissipation, LyapunovCandidate, ParameterError, PortEnergy, PortSample, Snapshot,
};
use pyo3::prelude::*;

use super::sample::accepted;
use super::{Raised, Sample};
use crate::axes::Axes;

/// Candidate of an observer.
#[derive(Debug)]
pub(crate) enum Candidate {
    /// The port's energy, with the credit of a damper.
    Damped((PortEnergy, Dissipation<f64>)),
    /// An object with a method `decrease(sample)`.
    Python { object: Py<PyAny>, raised: Raised },
}

impl<V: Axes> LyapunovCandidate<V> for Candidate {
    #[inline]
    fn decrease(&mut self, sample: &PortSample<V>) -> f64 {
        match self {
            Self::Damped(candidate) => candidate.decrease(sample),
            Self::Python { object, raised } => decrease(object, raised, accepted(*sample)),
        }
    }
}

/// What the object says; NaN, which a stabilizer rejects, if it raises.
fn decrease<V: Axes>(object: &Py<PyAny>, raised: &Raised, sample: CheckedSample<V>) -> f64 {
    Python::attach(|py| {
        let told = object.call_method1(py, "decrease", (Sample(V::sample(sample)),));
        told.and_then(|told| told.extract(py)).unwrap_or_else(|error| {
            raised.keep(error);
            f64::NAN
        })
    })
}

/// The memory of a candidate in Python is its own.
impl Snapshot for Candidate {
    type State = ();

    fn state(&self) {}

    fn restored(self, _state: ()) -> Result<Self, ParameterError> {
        Ok(self)
    }
}
