//! Blocks of a control loop: readings, stabilizers, observers and candidates.

mod candidate;
mod correction;
mod deep_copy;
mod in_use;
mod limit;
mod observer;
mod python_stabilizer;
mod readings;
mod recipe;
mod sample;
mod stabilizer;

pub(crate) use candidate::Candidate;
pub(crate) use correction::{AnyCorrection, Correction};
pub(crate) use in_use::{seen, taken};
pub(crate) use limit::damping_limit;
pub(crate) use observer::Observer;
pub(crate) use python_stabilizer::{Asker, PythonStabilizer};
pub(crate) use readings::{AnyReadings, Kinds, Readings};
pub(crate) use recipe::Recipe;
pub(crate) use sample::{AnySample, Sample};
pub(crate) use stabilizer::{AnyMember, Stabilizer};

use std::sync::{Arc, Mutex, PoisonError};

use pyo3::prelude::*;

/// What a method written in Python raised, kept until the call that it was part of is over.
#[derive(Clone, Debug, Default)]
pub(crate) struct Raised(Arc<Mutex<Option<PyErr>>>);

impl Raised {
    /// Keeps an error, the first of several.
    pub(crate) fn keep(&self, error: PyErr) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
    }

    /// Whether an error is kept.
    pub(crate) fn is_kept(&self) -> bool {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).is_some()
    }

    /// Raises what was kept.
    pub(crate) fn check(&self) -> PyResult<()> {
        match self.0.lock().unwrap_or_else(PoisonError::into_inner).take() {
            Some(error) => Err(error),
            None => Ok(()),
        }
    }
}
