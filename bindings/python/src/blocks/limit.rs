//! Damping limit.

use lyapunov::DampingLimit;
use pyo3::prelude::*;

use crate::errors;
use crate::number;
use crate::whole;

/// The largest damping that a stabilizer may inject, N·s/m: `cap · mass / period`, less where the force acts late.
///
/// `mass`, kg, is the smallest that moves with the port, `period`, s, the time between two ticks, and `delay` the ticks by
/// which an effort acts late. A cap of 0 makes a pure observer; half of `mass / period` is the default of scenes.
#[pyfunction]
#[pyo3(signature = (mass, period, *, cap=0.5, delay=0))]
pub(crate) fn damping_limit(
    #[pyo3(from_py_with = number::mass)] mass: f64,
    #[pyo3(from_py_with = number::period)] period: f64,
    #[pyo3(from_py_with = number::cap)] cap: f64,
    #[pyo3(from_py_with = whole::delay)] delay: u32,
) -> PyResult<f64> {
    let limit = DampingLimit::of_mass(cap, mass, period).map_err(errors::parameter)?;
    Ok(limit.delayed(delay).most())
}
