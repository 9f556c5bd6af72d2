//! Signals of one axis or several, between Python and Rust.

use lyapunov::stabilizers::Member;
use lyapunov::{CheckedSample, Correction, Signal};
use nalgebra::SVector;
use numpy::{PyArray1, PyArrayDescrMethods, PyArrayMethods, PyUntypedArray, PyUntypedArrayMethods};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyFloat, PySequence, PyString};
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::errors::{self, kind};
use crate::number;

use crate::blocks::{AnyCorrection, AnyMember, AnyReadings, AnySample, Candidate, Kinds, Readings};

/// The numbers of axes that blocks are compiled for.
pub(crate) const COUNTS: [usize; 5] = [1, 2, 3, 6, 7];

/// Signal of a block: a number, or a vector of as many as [`COUNTS`] says.
pub(crate) trait Axes:
    Signal<Scalar = f64> + Send + Sync + Serialize + DeserializeOwned
{
    /// The number of axes.
    const COUNT: usize;

    /// The signal that a value of Python, called `name`, tells.
    fn read(value: &Bound<'_, PyAny>, name: &str) -> PyResult<Self>;

    /// The value for Python: a number, or an array of shape (axes,).
    fn show(self, py: Python<'_>) -> Bound<'_, PyAny>;

    /// The signal that is `value(axis)` on each axis.
    fn from_axes(value: impl FnMut(usize) -> f64) -> Self;

    /// The number along an axis.
    fn along(&self, axis: usize) -> f64;

    /// The sample, whatever its axes.
    fn sample(sample: CheckedSample<Self>) -> AnySample;

    /// The sample of as many axes.
    fn of_sample(sample: &AnySample) -> PyResult<&CheckedSample<Self>>;

    /// The correction, whatever its axes.
    fn correction(correction: Correction<Self>) -> AnyCorrection;

    /// The correction of as many axes.
    fn of_correction(correction: &AnyCorrection) -> PyResult<&Correction<Self>>;

    /// The stabilizer of as many axes.
    fn member(member: &mut AnyMember) -> PyResult<&mut Member<Self, Candidate>>;

    /// The readings of as many axes.
    fn readings(readings: &mut Readings) -> PyResult<&mut Kinds<Self>>;
}

/// The error of a value that is no signal of `count` axes.
fn wrong(value: &Bound<'_, PyAny>, name: &str, count: usize) -> PyErr {
    let wanted = match count {
        1 => "a number".to_owned(),
        count => format!(
            "an array of real numbers of shape ({count},), or a sequence of {count} numbers"
        ),
    };
    let other = match several(value).filter(|axes| *axes != count) {
        Some(axes) => format!(", or make it with axes={axes}"),
        None => String::new(),
    };
    PyTypeError::new_err(format!("{name} is {}; give {wanted}{other}", kind(value)))
}

/// The number of axes of a block that takes the value as a vector; none if there is no such block.
fn several(value: &Bound<'_, PyAny>) -> Option<usize> {
    let count = match value.cast::<PyUntypedArray>() {
        Ok(array) if array.ndim() == 1 => array.len(),
        Ok(_) => return None,
        Err(_) if value.is_instance_of::<PyString>() => return None,
        Err(_) => value.cast::<PySequence>().ok()?.len().ok()?,
    };
    (count > 1 && COUNTS.contains(&count)).then_some(count)
}

/// The error of an array that does not lie where a float64 may.
pub(crate) fn misaligned(name: &str) -> PyErr {
    errors::input(format!(
        "{name} is not aligned in memory, as an array over foreign bytes may be; give numpy.array({name}), a copy"
    ))
}

/// The methods of an implementation that name a variant.
macro_rules! in_variant {
    ($variant:ident, $count:literal) => {
        fn sample(sample: CheckedSample<Self>) -> AnySample {
            AnySample::$variant(sample)
        }

        fn of_sample(sample: &AnySample) -> PyResult<&CheckedSample<Self>> {
            match sample {
                AnySample::$variant(sample) => Ok(sample),
                other => Err(differs("sample has", other.axes(), "block", $count)),
            }
        }

        fn correction(correction: Correction<Self>) -> AnyCorrection {
            AnyCorrection::$variant(correction)
        }

        fn of_correction(correction: &AnyCorrection) -> PyResult<&Correction<Self>> {
            match correction {
                AnyCorrection::$variant(correction) => Ok(correction),
                other => Err(differs("correction has", other.axes(), "block", $count)),
            }
        }

        fn member(member: &mut AnyMember) -> PyResult<&mut Member<Self, Candidate>> {
            match member {
                AnyMember::$variant(member) => Ok(member),
                other => Err(differs("array has", $count, "block", other.axes())),
            }
        }

        fn readings(readings: &mut Readings) -> PyResult<&mut Kinds<Self>> {
            match &mut readings.readings {
                AnyReadings::$variant(kinds) => Ok(kinds),
                other => Err(differs("readings have", other.axes(), "stabilizer", $count)),
            }
        }
    };
}

impl Axes for f64 {
    const COUNT: usize = 1;

    #[inline]
    fn read(value: &Bound<'_, PyAny>, name: &str) -> PyResult<Self> {
        if let Ok(number) = value.cast_exact::<PyFloat>() {
            return Ok(number.value());
        }
        if let Ok(array) = value.cast::<PyUntypedArray>() {
            unmasked(array, name)?;
        }
        number::real(value)?.ok_or_else(|| wrong(value, name, 1))
    }

    #[inline]
    fn show(self, py: Python<'_>) -> Bound<'_, PyAny> {
        PyFloat::new(py, self).into_any()
    }

    fn from_axes(mut value: impl FnMut(usize) -> f64) -> Self {
        value(0)
    }

    fn along(&self, _axis: usize) -> f64 {
        *self
    }

    in_variant!(One, 1);
}

macro_rules! vectors {
    ($($variant:ident $count:literal),+) => {$(
        impl Axes for SVector<f64, $count> {
            const COUNT: usize = $count;

            fn read(value: &Bound<'_, PyAny>, name: &str) -> PyResult<Self> {
                vector(value, name)
            }

            fn show(self, py: Python<'_>) -> Bound<'_, PyAny> {
                PyArray1::from_slice(py, self.as_slice()).into_any()
            }

            fn from_axes(mut value: impl FnMut(usize) -> f64) -> Self {
                Self::from_fn(|axis, _| value(axis))
            }

            fn along(&self, axis: usize) -> f64 {
                self[axis]
            }

            in_variant!($variant, $count);
        }
    )+};
}

vectors!(Two 2, Three 3, Six 6, Seven 7);

/// The vector that an array of float64 or a sequence of numbers tells.
fn vector<const N: usize>(value: &Bound<'_, PyAny>, name: &str) -> PyResult<SVector<f64, N>> {
    if let Ok(array) = value.cast::<PyArray1<f64>>() {
        if array.len() != N {
            return Err(wrong(value, name, N));
        }
        if !array.is_aligned() {
            return Err(misaligned(name));
        }
        unmasked(array.as_untyped(), name)?;
        // One by one: to borrow the array takes longer than the step.
        return Ok(SVector::from_fn(|axis, _| array.get_owned([axis]).unwrap_or(f64::NAN)));
    }
    if let Ok(array) = value.cast::<PyUntypedArray>() {
        return converted(array, name);
    }
    let Some(items) = value.cast::<PySequence>().ok().filter(|it| it.len().is_ok_and(|n| n == N))
    else {
        return Err(wrong(value, name, N));
    };
    let mut numbers = SVector::zeros();
    for axis in 0..N {
        numbers[axis] =
            number::real(&items.get_item(axis)?)?.ok_or_else(|| wrong(value, name, N))?;
    }
    Ok(numbers)
}

/// The vector that an array of other real numbers tells.
fn converted<const N: usize>(
    array: &Bound<'_, PyUntypedArray>,
    name: &str,
) -> PyResult<SVector<f64, N>> {
    let is_real = matches!(array.dtype().kind(), b'i' | b'u' | b'f');
    if !is_real || array.shape() != [N] {
        return Err(wrong(array, name, N));
    }
    unmasked(array, name)?;
    vector(&array.call_method1("astype", ("float64",))?, name)
}

/// Refuses an array that masks some of its numbers.
pub(crate) fn unmasked(array: &Bound<'_, PyUntypedArray>, name: &str) -> PyResult<()> {
    // Only what is derived from an array has a mask.
    match array.is_exact_instance_of::<PyUntypedArray>() || !array.hasattr("mask")? {
        true => Ok(()),
        false => Err(errors::input(format!(
            "{name} is a masked array\n  = give {name}.filled(numpy.nan): NaN is no reading"
        ))),
    }
}

/// The error of what has `found` axes, as in "sample has", for what has `wanted`, as a "block".
fn differs(what_has: &str, found: usize, whom: &str, wanted: usize) -> PyErr {
    let axes = if found == 1 { "axis" } else { "axes" };
    errors::input(format!(
        "the {what_has} {found} {axes} and the {whom} {wanted}; make both with the same axes="
    ))
}

/// The error of a number of axes that no block has.
pub(crate) fn no_block_of(axes: impl std::fmt::Display) -> PyErr {
    errors::input(format!(
        "axes is {axes}; blocks are compiled for {COUNTS:?}: fill up with axes that stay at 0, or take one block for each"
    ))
}

/// Enumeration of a generic type, with a variant for each number of axes.
macro_rules! on_any_axes {
    ($(#[$about:meta])* enum $name:ident of $of:ident) => {
        $(#[$about])*
        pub(crate) enum $name {
            One($of<f64>),
            Two($of<nalgebra::SVector<f64, 2>>),
            Three($of<nalgebra::SVector<f64, 3>>),
            Six($of<nalgebra::SVector<f64, 6>>),
            Seven($of<nalgebra::SVector<f64, 7>>),
        }

        impl $name {
            /// The number of axes.
            pub(crate) fn axes(&self) -> usize {
                match self {
                    Self::One(_) => 1,
                    Self::Two(_) => 2,
                    Self::Three(_) => 3,
                    Self::Six(_) => 6,
                    Self::Seven(_) => 7,
                }
            }
        }
    };
}

/// An expression of what is in such an enumeration, whatever its axes.
macro_rules! whatever_axes {
    ($value:expr, $enum:ident, $inner:ident => $expression:expr) => {
        match $value {
            $enum::One($inner) => $expression,
            $enum::Two($inner) => $expression,
            $enum::Three($inner) => $expression,
            $enum::Six($inner) => $expression,
            $enum::Seven($inner) => $expression,
        }
    };
}

/// Such an enumeration, made by an expression of the signal's type for a number of axes.
macro_rules! with_axes {
    ($axes:expr, $enum:ident, $signal:ident => $expression:expr) => {{
        use nalgebra::SVector;
        match $axes {
            1 => {
                type $signal = f64;
                Ok($enum::One($expression))
            }
            2 => {
                type $signal = SVector<f64, 2>;
                Ok($enum::Two($expression))
            }
            3 => {
                type $signal = SVector<f64, 3>;
                Ok($enum::Three($expression))
            }
            6 => {
                type $signal = SVector<f64, 6>;
                Ok($enum::Six($expression))
            }
            7 => {
                type $signal = SVector<f64, 7>;
                Ok($enum::Seven($expression))
            }
            axes => Err($crate::axes::no_block_of(axes)),
        }
    }};
}

pub(crate) use {on_any_axes, whatever_axes, with_axes};
