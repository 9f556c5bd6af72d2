//! Units of the numbers of scenes.

use lyapunov_lab::map::Axis;
use pyo3::prelude::*;

use crate::errors;

/// The unit of an axis, KEY=FROM..TO:N; empty where it has none.
#[pyfunction]
pub(crate) fn unit_of(axis: &str) -> PyResult<&'static str> {
    let axis: Axis = axis.parse().map_err(errors::input)?;
    Ok(axis.unit())
}
