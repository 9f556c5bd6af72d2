//! Candidate of an observer: the port's energy, with a damper credited, or one written in Python.

use std::sync::Arc;

use lyapunov::{
    CheckedSample, Dissipation, LyapunovCandidate, ParameterError, PortEnergy, PortSample, Snapshot,
};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

use super::sample::checked;
use super::{Raised, Sample};
use crate::axes::Axes;
use crate::errors::{self, kind};
use crate::number;

/// Candidate of an observer.
#[derive(Debug)]
pub(crate) enum Candidate {
    /// The port's energy, with the credit of a damper.
    Damped((PortEnergy, Dissipation<f64>)),
    /// An object with a method `decrease(sample)`.
    Python { object: Arc<Py<PyAny>>, raised: Raised },
}

impl<V: Axes> LyapunovCandidate<V> for Candidate {
    #[inline]
    fn decrease(&mut self, sample: &PortSample<V>) -> f64 {
        match self {
            Self::Damped(candidate) => candidate.decrease(sample),
            Self::Python { object, raised } => decrease(object, raised, checked(*sample)),
        }
    }
}

impl Candidate {
    /// An object written in Python, with the method that a candidate has.
    pub(crate) fn checked(object: Bound<'_, PyAny>) -> PyResult<Py<PyAny>> {
        let remedy = "an object with a method decrease(sample), which returns joules";
        errors::with_method(&object, "candidate", "decrease", remedy)?;
        Ok(object.unbind())
    }
}

/// What the object says; NaN, which a stabilizer rejects, if it raises.
fn decrease<V: Axes>(object: &Py<PyAny>, raised: &Raised, sample: CheckedSample<V>) -> f64 {
    let told = Python::try_attach(|py| {
        let told = object.call_method1(py, "decrease", (Sample(V::sample(sample)),));
        let number = told.and_then(|told| {
            let told = told.bind(py);
            number::real(told)?.ok_or_else(|| no_number(object.bind(py), told))
        });
        number.unwrap_or_else(|error| {
            raised.keep(error);
            f64::NAN
        })
    });
    // An interpreter that ends cannot be asked.
    told.unwrap_or(f64::NAN)
}

/// The error of what `object` returned, which is no number.
fn no_number(object: &Bound<'_, PyAny>, told: &Bound<'_, PyAny>) -> PyErr {
    PyTypeError::new_err(format!(
        "decrease(sample) of {} returned {}; return a number, in J, such as numpy.sum(sample.work)",
        kind(object),
        kind(told)
    ))
}

/// The memory of a candidate in Python is its own.
impl Snapshot for Candidate {
    type State = ();

    fn state(&self) {}

    fn restored(self, _state: ()) -> Result<Self, ParameterError> {
        Ok(self)
    }
}
