//! Arrays of NumPy as slices.

use numpy::{
    PyArray, PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArray, PyUntypedArrayMethods,
};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

use crate::axes::{misaligned, unmasked};
use crate::errors;

/// An array of float64 in the order of C, with its name in messages.
pub(super) struct Given<'py> {
    array: PyReadonlyArrayDyn<'py, f64>,
    name: &'static str,
}

impl<'py> Given<'py> {
    /// The array that `value` is.
    pub(super) fn of(value: &Bound<'py, PyAny>, name: &'static str) -> PyResult<Self> {
        let wrong = |found: String| {
            PyTypeError::new_err(format!("{name} is {found}; give an array of float64"))
        };
        let Ok(array) = value.cast::<PyArrayDyn<f64>>() else {
            return Err(match value.cast::<PyUntypedArray>() {
                Ok(array) => wrong(format!("an array of {}", array.dtype())),
                Err(_) => wrong(value.get_type().name()?.to_string()),
            });
        };
        unmasked(array.as_untyped(), name)?;
        if !array.is_c_contiguous() {
            return Err(errors::input(format!(
                "{name} is not contiguous, and is not copied here; give numpy.ascontiguousarray({name})"
            )));
        }
        if !array.is_aligned() {
            return Err(misaligned(name));
        }
        let array = array.try_readonly().map_err(|_| {
            errors::input(format!("{name} is an array that another call writes to now"))
        })?;
        Ok(Self { array, name })
    }

    /// The shape.
    pub(super) fn shape(&self) -> &[usize] {
        self.array.shape()
    }

    /// The numbers.
    pub(super) fn numbers(&self) -> PyResult<&[f64]> {
        self.array.as_slice().map_err(errors::input)
    }

    /// Error if the shape is another one.
    pub(super) fn is_like(&self, other: &Self) -> PyResult<()> {
        match self.shape() == other.shape() {
            true => Ok(()),
            false => Err(errors::input(format!(
                "{} has the shape {:?} and {} has {:?}; give both the same shape",
                self.name,
                self.shape(),
                other.name,
                other.shape()
            ))),
        }
    }

    /// The error of a shape that is not `wanted`.
    pub(super) fn not(&self, wanted: &str) -> PyErr {
        errors::input(format!("{} has the shape {:?}; give {wanted}", self.name, self.shape()))
    }
}

/// A new array of this shape.
pub(super) fn array<'py, T: numpy::Element>(
    py: Python<'py>,
    numbers: Vec<T>,
    shape: &[usize],
) -> PyResult<Bound<'py, PyArrayDyn<T>>> {
    PyArray::from_vec(py, numbers).reshape(shape)
}
