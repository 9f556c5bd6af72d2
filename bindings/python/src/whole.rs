//! Whole numbers that a call gives, which name themselves where they do not fit.

use pyo3::exceptions::{PyOverflowError, PyTypeError};
use pyo3::prelude::*;

use crate::axes::no_block_of;
use crate::errors::{self, kind};

/// The whole number that `value`, the argument `name`, is; `least` is the smallest that may be.
fn ranged<'py, T>(value: &Bound<'py, PyAny>, name: &str, least: u8) -> PyResult<T>
where
    T: Fits + From<u8> + PartialOrd + for<'a> FromPyObject<'a, 'py, Error = PyErr>,
{
    match value.extract::<T>() {
        Ok(number) if number >= T::from(least) => Ok(number),
        Err(error) if !error.is_instance_of::<PyOverflowError>(value.py()) => {
            Err(PyTypeError::new_err(format!(
                "{name} is {value}, of the type {}; give a whole number, an int",
                kind(value)
            )))
        }
        _ if value.gt(least)? => {
            Err(errors::input(format!("{name} is {value}; it must be {} or less", T::most())))
        }
        _ => Err(errors::input(format!("{name} is {value}; it must be {least} or more"))),
    }
}

/// The same of 0 or more.
fn whole<'py, T>(value: &Bound<'py, PyAny>, name: &str) -> PyResult<T>
where
    T: Fits + From<u8> + PartialOrd + for<'a> FromPyObject<'a, 'py, Error = PyErr>,
{
    ranged(value, name, 0)
}

/// The same of 1 or more.
fn count<'py, T>(value: &Bound<'py, PyAny>, name: &str) -> PyResult<T>
where
    T: Fits + From<u8> + PartialOrd + for<'a> FromPyObject<'a, 'py, Error = PyErr>,
{
    ranged(value, name, 1)
}

/// A number of axes.
pub(crate) fn axes(value: &Bound<'_, PyAny>) -> PyResult<usize> {
    value.extract().map_err(|error: PyErr| {
        match error.is_instance_of::<PyOverflowError>(value.py()) {
            true => no_block_of(value),
            false => whole::<usize>(value, "axes").err().unwrap_or(error),
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

/// Readers of the arguments with these names, whole numbers or counts.
macro_rules! arguments {
    ($read:ident of $($name:ident: $type:ty),+ $(,)?) => {$(
        pub(crate) fn $name(value: &Bound<'_, PyAny>) -> PyResult<$type> {
            $read(value, stringify!($name))
        }
    )+};
}

arguments!(whole of delay: u32, seed: u64, ticks: u64);
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
