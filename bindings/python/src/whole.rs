//! Whole numbers among the arguments of a call, with errors that name the argument.

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

/// A number of axes.
pub(crate) fn axes(value: &Bound<'_, PyAny>) -> PyResult<usize> {
    value.extract().map_err(|error: PyErr| {
        match error.is_instance_of::<PyOverflowError>(value.py()) {
            true => no_block_of(value),
            false => ranged::<usize>(value, "axes", 0).err().unwrap_or(error),
        }
    })
}

/// Whole number of a fixed size.
trait Fits {
    /// The largest that fits.
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

/// Readers of the arguments with these names, each so much or more.
macro_rules! arguments {
    ($least:literal or more: $($name:ident: $type:ty),+ $(,)?) => {$(
        pub(crate) fn $name(value: &Bound<'_, PyAny>) -> PyResult<$type> {
            ranged(value, stringify!($name), $least)
        }
    )+};
}

arguments!(0 or more: delay: u32, late: u32, seed: u64, ticks: u64);
arguments!(1 or more: loops: usize, members: u64);

/// Readers of the arguments with these names, which may be left out.
macro_rules! choices {
    ($least:literal or more: $($reader:ident $name:literal: $type:ty),+ $(,)?) => {$(
        pub(crate) fn $reader(value: &Bound<'_, PyAny>) -> PyResult<Option<$type>> {
            (!value.is_none()).then(|| ranged(value, $name, $least)).transpose()
        }
    )+};
}

choices!(0 or more: runs_if_any "runs": u32, seed_if_any "seed": u64, trials_if_any "trials": u32);
choices!(1 or more: threads_if_any "threads": usize);
