//! Replay of recorded ticks through one loop.

use lyapunov::Correction;
use pyo3::prelude::*;

use super::arrays::Given;
use super::corrections::{Corrections, Written, scarce};
use crate::axes::Axes;
use crate::blocks::{Readings, Stabilizer, taken};
use crate::errors::of_class;
use nalgebra::SVector;

/// What readings and a stabilizer make of recorded ticks, as if they had been called for one after the other.
///
/// `position`, m, `applied`, N, the effort that acted since the tick before, and `effort`, N: float64 arrays of shape (time,)
/// on one axis, (time, axes) on several, contiguous; they are not copied, and the interpreter's lock is not held.
#[pyfunction]
pub(crate) fn replay<'py>(
    py: Python<'py>,
    readings: &Bound<'py, PyAny>,
    stabilizer: &Bound<'py, PyAny>,
    position: &Bound<'py, PyAny>,
    applied: &Bound<'py, PyAny>,
    effort: &Bound<'py, PyAny>,
) -> PyResult<Corrections> {
    let mut readings = taken(of_class::<Readings>(readings, "readings")?)?;
    let mut stabilizer = taken(of_class::<Stabilizer>(stabilizer, "stabilizer")?)?;
    let given = [
        Given::of(position, "position")?,
        Given::of(applied, "applied")?,
        Given::of(effort, "effort")?,
    ];
    let axes = stabilizer.count();
    let (readings, stabilizer) = (&mut *readings, &mut *stabilizer);
    match axes {
        1 => replayed::<f64>(py, readings, stabilizer, &given),
        2 => replayed::<SVector<f64, 2>>(py, readings, stabilizer, &given),
        3 => replayed::<SVector<f64, 3>>(py, readings, stabilizer, &given),
        6 => replayed::<SVector<f64, 6>>(py, readings, stabilizer, &given),
        _ => replayed::<SVector<f64, 7>>(py, readings, stabilizer, &given),
    }
}

fn replayed<V: Axes>(
    py: Python<'_>,
    readings: &mut Readings,
    stabilizer: &mut Stabilizer,
    given: &[Given<'_>; 3],
) -> PyResult<Corrections> {
    let [position, applied, effort] = given;
    let wanted = if V::COUNT == 1 { "(time,)".to_owned() } else { format!("(time, {})", V::COUNT) };
    let is_right = match position.shape() {
        [_] => V::COUNT == 1,
        [_, axes] => V::COUNT > 1 && *axes == V::COUNT,
        _ => false,
    };
    if !is_right {
        return Err(position.not(&wanted));
    }
    applied.is_like(position)?;
    effort.is_like(position)?;
    let shape = position.shape().to_vec();
    let numbers = [position.numbers()?, applied.numbers()?, effort.numbers()?];
    let memory = V::readings(readings)?;
    let written = py.detach(|| {
        stabilizer.with_member::<V, _>(|stabilize| {
            let mut written = Written::room(shape[0], V::COUNT).map_err(|_| scarce(shape[0], 1))?;
            for tick in 0..shape[0] {
                let at = |numbers: &[f64]| V::from_axes(|axis| numbers[tick * V::COUNT + axis]);
                let [position, applied, effort] = numbers.map(at);
                let told: Correction<V> =
                    stabilize(&memory.read_plain(position, applied)?, effort)?;
                for axis in 0..V::COUNT {
                    written.effort[tick * V::COUNT + axis] = told.effort.along(axis);
                }
                written.observed_energy[tick] = told.observed_energy;
                written.alpha[tick] = told.alpha;
                written.shortfall[tick] = told.shortfall;
                written.accepted[tick] = told.accepted;
            }
            Ok(written)
        })
    })?;
    written.shown(py, &shape, V::COUNT)
}
