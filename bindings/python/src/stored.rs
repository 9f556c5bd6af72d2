//! Objects as pickle stores them, with bytes that keep every bit.

use pyo3::PyTypeInfo;
use pyo3::prelude::*;
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::errors;

/// The bytes of a value.
pub(crate) fn write(value: &impl Serialize) -> PyResult<Vec<u8>> {
    let mut bytes = Vec::new();
    ciborium::into_writer(value, &mut bytes).map_err(errors::internal)?;
    Ok(bytes)
}

/// The value of such bytes.
pub(crate) fn read<T: DeserializeOwned>(bytes: &[u8]) -> PyResult<T> {
    ciborium::from_reader(bytes)
        .map_err(|error| errors::input(format!("the memory is damaged: {error}")))
}

/// The answer of `__reduce__`: the class makes the object again from `parts`, by its static method `_restored`.
pub(crate) fn again<'py, T: PyTypeInfo>(
    object: &Bound<'py, T>,
    parts: impl IntoPyObject<'py>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = object.py();
    let restored = py.get_type::<T>().getattr("_restored")?;
    (restored, parts).into_pyobject(py).map(Bound::into_any)
}
