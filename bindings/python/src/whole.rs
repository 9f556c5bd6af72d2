//! Whole numbers that a call gives, which name themselves where they do not fit.

use pyo3::exceptions::PyOverflowError;
use pyo3::prelude::*;

use crate::errors;

/// The whole number that `value`, the argument `name`, is.
fn whole<'py, T>(value: &Bound<'py, PyAny>, name: &str) -> PyResult<T>
where
    T: Fits + for<'a> FromPyObject<'a, 'py, Error = PyErr>,
{
    value.extract().map_err(|error: PyErr| {
        match error.is_instance_of::<PyOverflowError>(value.py()) {
            true => errors::input(format!(
                "{name} is {value}; it must be a whole number from 0 to {}",
                T::most()
            )),
            false => error,
        }
    })
}

/// Whole number of the machine.
trait Fits {
    /// The largest.
    fn most() -> u64;
}

impl Fits for u32 {
    fn most() -> u64 {
        Self::MAX.into()
    }
}

impl Fits for u64 {
    fn most() -> u64 {
        Self::MAX
    }
}

impl Fits for usize {
    fn most() -> u64 {
        Self::MAX as u64
    }
}

/// The same of 1 or more.
fn count<'py, T>(value: &Bound<'py, PyAny>, name: &str) -> PyResult<T>
where
    T: Fits + Default + PartialEq + for<'a> FromPyObject<'a, 'py, Error = PyErr>,
{
    match whole::<T>(value, name)? {
        none if none == T::default() => {
            Err(errors::input(format!("{name} is 0; it must be 1 or more")))
        }
        count => Ok(count),
    }
}

/// Readers of the arguments with these names, whole numbers or counts.
macro_rules! arguments {
    ($read:ident of $($name:ident: $type:ty),+ $(,)?) => {$(
        pub(crate) fn $name(value: &Bound<'_, PyAny>) -> PyResult<$type> {
            $read(value, stringify!($name))
        }
    )+};
}

arguments!(whole of axes: usize, delay: u32, seed: u64, ticks: u64);
arguments!(count of loops: usize, members: u64);

/// Readers of the arguments with these names, which may be left out.
macro_rules! choices {
    ($read:ident of $($reader:ident $name:literal: $type:ty),+ $(,)?) => {$(
        pub(crate) fn $reader(value: &Bound<'_, PyAny>) -> PyResult<Option<$type>> {
            (!value.is_none()).then(|| $read(value, $name)).transpose()
        }
    )+};
}

choices!(whole of runs_if_any "runs": u32, seed_if_any "seed": u64, trials_if_any "trials": u32);
choices!(count of threads_if_any "threads": usize);
