//! What blocks remember as bytes that keep every bit.

use pyo3::prelude::*;
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::errors;

/// The bytes of a value.
pub(super) fn write(value: &impl Serialize) -> PyResult<Vec<u8>> {
    let mut bytes = Vec::new();
    ciborium::into_writer(value, &mut bytes).map_err(errors::internal)?;
    Ok(bytes)
}

/// The value of such bytes.
pub(super) fn read<T: DeserializeOwned>(bytes: &[u8]) -> PyResult<T> {
    ciborium::from_reader(bytes)
        .map_err(|error| errors::input(format!("the memory is damaged: {error}")))
}
