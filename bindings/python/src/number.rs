//! Numbers and truths among the arguments of a call, with errors that name the argument.

use numpy::{PyArrayDescr, PyArrayDescrMethods, PyUntypedArray, PyUntypedArrayMethods};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyFloat, PyInt};

use crate::errors::kind;

/// The number that `value` is; none where its type is another one, and what a type of the caller raises as it is.
#[inline]
pub(crate) fn real(value: &Bound<'_, PyAny>) -> PyResult<Option<f64>> {
    match value.cast::<PyFloat>() {
        Ok(number) => Ok(Some(number.value())),
        Err(_) => converted(value),
    }
}

/// The number that a value of another type tells.
fn converted(value: &Bound<'_, PyAny>) -> PyResult<Option<f64>> {
    // NumPy converts what is no real number as well: texts, times, the real part of what is complex, and arrays of one.
    if !value.is_instance_of::<PyInt>() {
        if value.cast::<PyUntypedArray>().is_ok_and(|array| array.ndim() > 0) {
            return Ok(None);
        }
        let described = value.getattr("dtype").ok();
        let described = described.as_ref().and_then(|it| it.cast::<PyArrayDescr>().ok());
        if described.is_some_and(|it| !b"biuf".contains(&it.kind())) {
            return Ok(None);
        }
    }
    match value.extract() {
        Ok(number) => Ok(Some(number)),
        Err(error) if error.is_instance_of::<PyTypeError>(value.py()) => Ok(None),
        Err(error) => Err(error),
    }
}

/// The number that `value`, the argument `name`, is.
pub(crate) fn number(value: &Bound<'_, PyAny>, name: &str) -> PyResult<f64> {
    real(value)?.ok_or_else(|| {
        let found = kind(value);
        PyTypeError::new_err(format!("{name} is {found}, which is no number\n  = give a float"))
    })
}

/// The truth that `value`, the argument `name`, is.
fn truth(value: &Bound<'_, PyAny>, name: &str) -> PyResult<bool> {
    if let Ok(truth) = value.cast::<PyBool>() {
        return Ok(truth.is_true());
    }
    // NumPy has truths of its own.
    value.extract().map_err(|_| {
        let found = kind(value);
        PyTypeError::new_err(format!(
            "{name} is {found}, which is no truth\n  = give True or False"
        ))
    })
}

/// Readers of the arguments with these names.
macro_rules! arguments {
    ($read:ident -> $type:ty: $($name:ident),+) => {$(
        pub(crate) fn $name(value: &Bound<'_, PyAny>) -> PyResult<$type> {
            $read(value, stringify!($name))
        }
    )+};
}

arguments!(number -> f64: alpha, cap, mass, observed_energy, period, shortfall);
arguments!(truth -> bool: accepted, clocked, measured, rows);

/// Readers of the numbers with these names, which may be left out.
macro_rules! choices {
    ($($reader:ident $name:literal),+ $(,)?) => {$(
        pub(crate) fn $reader(value: &Bound<'_, PyAny>) -> PyResult<Option<f64>> {
            (!value.is_none()).then(|| number(value, $name)).transpose()
        }
    )+};
}

choices!(
    contact_if_any "contact",
    cutoff_if_any "cutoff",
    damping_if_any "damping",
    mass_if_any "mass",
    no_faster_than_if_any "no_faster_than",
    now_if_any "now",
    phase_if_any "phase",
    stiffness_if_any "stiffness",
    surface_if_any "surface",
    target_if_any "target",
);
