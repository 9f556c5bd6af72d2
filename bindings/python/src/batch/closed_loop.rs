//! Closed loops of a mass on a hand against a wall, many at once.

use lyapunov::bodies::Impedance;
use lyapunov::stabilizers::Member;
use lyapunov::{Dissipation, ParameterError, PortEnergy, Scalar};
use lyapunov_lab::map::{self, Ends, Loops, Numbers};
use pyo3::exceptions::PyMemoryError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::arrays::{Given, array};
use crate::blocks::{Recipe, Stabilizer, seen};
use crate::errors::{self, of_class};
use crate::lab::{Fault, wait_here};
use crate::number;
use crate::whole;

/// Simulates closed loops: a mass with damping on a hand's spring, moved exactly, against a one-sided wall that is sampled and
/// held, with a stabilizer at the servo's rate. Returns float64 arrays of shape (loops,) by name: `position`, m, and
/// `velocity`, m/s, at the end, `observed_energy`, J, that at the wall's port before the last tick's correction, without a
/// stabilizer too, and `largest`, the largest |position| from half of the ticks on to the end, both counted, m.
///
/// `mass`, kg, `damping`, N·s/m, and `stiffness`, N/m, of hand and device together, the hand resting at 0; `position`, m, and
/// `velocity`, m/s, at the start; `wall_stiffness`, N/m, `wall_damping`, N·s/m, and `wall_position`, m: each a float, or a
/// float64 array of shape (loops,), contiguous. `period`, s, and `ticks` are the same for all, and so is `stabilizer`, of which every
/// loop has a fresh copy. There is no delay, encoder, saturation or other effect: `ensemble` and `map` run scenes with them.
#[pyfunction]
#[pyo3(signature = (ticks, period, *, mass, wall_stiffness, damping=None, stiffness=None, position=None, velocity=None,
    wall_damping=None, wall_position=None, stabilizer=None))]
#[allow(clippy::too_many_arguments)]
pub(crate) fn closed_loop<'py>(
    py: Python<'py>,
    #[pyo3(from_py_with = whole::ticks)] ticks: u64,
    #[pyo3(from_py_with = number::period)] period: f64,
    mass: &Bound<'py, PyAny>,
    wall_stiffness: &Bound<'py, PyAny>,
    damping: Option<&Bound<'py, PyAny>>,
    stiffness: Option<&Bound<'py, PyAny>>,
    position: Option<&Bound<'py, PyAny>>,
    velocity: Option<&Bound<'py, PyAny>>,
    wall_damping: Option<&Bound<'py, PyAny>>,
    wall_position: Option<&Bound<'py, PyAny>>,
    stabilizer: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let told = [
        Told::of(Some(mass), "mass")?,
        Told::of(damping, "damping")?,
        Told::of(stiffness, "stiffness")?,
        Told::of(position, "position")?,
        Told::of(velocity, "velocity")?,
        Told::of(Some(wall_stiffness), "wall_stiffness")?,
        Told::of(wall_damping, "wall_damping")?,
        Told::of(wall_position, "wall_position")?,
    ];
    let count = count(&told)?;
    let stabilizer = stabilizer.map(|it| seen(of_class(it, "stabilizer")?)).transpose()?;
    let recipe = recipe(py, stabilizer.as_deref())?;
    let [mass, damping, stiffness, position, velocity, wall_stiffness, wall_damping, wall_position] =
        told.each_ref().map(Told::numbers);
    let loops = Loops {
        count,
        ticks,
        period,
        impedance: Impedance { mass: mass?, damping: damping?, stiffness: stiffness? },
        position: position?,
        velocity: velocity?,
        wall_stiffness: wall_stiffness?,
        wall_damping: wall_damping?,
        wall_position: wall_position?,
    };
    let room = Ends::room(count).map_err(|_| {
        PyMemoryError::new_err(format!(
            "there is no memory for the ends of {count} loops; give fewer, in several calls"
        ))
    })?;
    let ends = wait_here(py, move |watched| {
        let ends = loops.ends(room, &recipe, &|| watched.go_on().is_continue());
        ends.map_err(errors::parameter)?.ok_or(Fault::Stopped)
    })?;
    let results = PyDict::new(py);
    let named = [
        ("position", ends.position),
        ("velocity", ends.velocity),
        ("observed_energy", ends.observed_energy),
        ("largest", ends.largest),
    ];
    for (name, numbers) in named {
        results.set_item(name, array(py, numbers, &[count])?)?;
    }
    Ok(results)
}

/// The number of loops.
fn count(told: &[Told<'_>]) -> PyResult<usize> {
    let counts: Vec<usize> = told.iter().filter_map(Told::count).collect();
    let count = counts.first().copied().unwrap_or(1);
    match count == 0 || counts.iter().any(|other| *other != count) {
        false => Ok(count),
        true => Err(errors::input(format!(
            "arrays of {counts:?} loops; give all the same length of 1 or more, or floats"
        ))),
    }
}

/// Maker of the stabilizer of every loop.
fn recipe(py: Python<'_>, stabilizer: Option<&Stabilizer>) -> PyResult<Recipe> {
    match stabilizer {
        Some(stabilizer) if stabilizer.count() != 1 || stabilizer.recipe.object.is_some() => {
            Err(errors::input(
                "closed loops have one axis and a candidate in Rust\n  = make the stabilizer with axes=1, and credit a damping",
            ))
        }
        Some(stabilizer) if stabilizer.recipe.name != "none" => Ok(stabilizer.recipe.again(py)),
        // What may inject nothing observes, and lets every finite effort pass.
        _ => Ok(Recipe::observing()),
    }
}

/// A number for all loops, or one for each.
enum Told<'py> {
    All(f64),
    Each(Given<'py>),
}

impl<'py> Told<'py> {
    fn of(value: Option<&Bound<'py, PyAny>>, name: &'static str) -> PyResult<Self> {
        let Some(value) = value else { return Ok(Self::All(0.0)) };
        if let Some(number) = number::real(value)? {
            return Ok(Self::All(number));
        }
        let given = Given::of(value, name)?;
        match given.shape() {
            [_] => Ok(Self::Each(given)),
            _ => Err(given.not("(loops,), or a float")),
        }
    }

    fn count(&self) -> Option<usize> {
        match self {
            Self::All(_) => None,
            Self::Each(given) => Some(given.shape()[0]),
        }
    }

    fn numbers(&self) -> PyResult<Numbers<'_>> {
        Ok(match self {
            Self::All(number) => Numbers::All(*number),
            Self::Each(given) => Numbers::Each(given.numbers()?),
        })
    }
}

impl map::Recipe for Recipe {
    fn make<T: Scalar>(&self) -> Result<Member<T, (PortEnergy, Dissipation<T>)>, ParameterError> {
        Recipe::make(self, || {
            Ok((PortEnergy, Dissipation::of(T::of(self.damping.unwrap_or(0.0)))?))
        })
    }
}
