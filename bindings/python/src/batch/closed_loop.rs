//! Closed loops of a mass on a hand against a wall, many at once.

use lyapunov::bodies::{Body, Impedance};
use lyapunov::effects::OnePortExt;
use lyapunov::environments::Wall;
use lyapunov::stabilizers::{Member, NoStabilizer};
use lyapunov::{
    Dissipation, OnePort, ParameterError, Plant, PortEnergy, PortSample, Scalar, Stabilizer as Step,
};
use lyapunov_lab::F64x8;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::prelude::*;

use super::arrays::{Given, array};
use super::lanes::{LANES, Lanes};
use crate::blocks::{Recipe, Stabilizer};
use crate::errors;
use crate::lab::pool;

/// Groups of loops that tick beside each other, so that one does not wait for the divisions of another.
const BESIDE: usize = 8;

/// The numbers of each loop, in this order.
const NAMES: [&str; 8] = [
    "mass",
    "damping",
    "stiffness",
    "position",
    "velocity",
    "wall_stiffness",
    "wall_damping",
    "wall_position",
];

/// Simulates closed loops: a mass with damping on a hand's spring, moved exactly, against a one-sided wall that is sampled and
/// held, with a stabilizer at the servo's rate. Returns float64 arrays of shape (loops,) by name: `position`, m, and
/// `velocity`, m/s, at the end, `observed_energy`, J, and `largest`, the largest |position| in the second half, m.
///
/// `mass`, kg, `damping`, N·s/m, and `stiffness`, N/m, of hand and device together, the hand resting at 0; `position`, m, and
/// `velocity`, m/s, at the start; `wall_stiffness`, N/m, `wall_damping`, N·s/m, and `wall_position`, m: each a float, or a
/// float64 array of shape (loops,), contiguous. `period`, s, and `ticks` are the same for all, and so is `stabilizer`, of which every
/// loop has a fresh copy.
#[pyfunction]
#[pyo3(signature = (ticks, period, *, mass, wall_stiffness, damping=None, stiffness=None, position=None, velocity=None,
    wall_damping=None, wall_position=None, stabilizer=None))]
#[allow(clippy::too_many_arguments)]
pub(crate) fn closed_loop<'py>(
    py: Python<'py>,
    ticks: u64,
    period: f64,
    mass: &Bound<'py, PyAny>,
    wall_stiffness: &Bound<'py, PyAny>,
    damping: Option<&Bound<'py, PyAny>>,
    stiffness: Option<&Bound<'py, PyAny>>,
    position: Option<&Bound<'py, PyAny>>,
    velocity: Option<&Bound<'py, PyAny>>,
    wall_damping: Option<&Bound<'py, PyAny>>,
    wall_position: Option<&Bound<'py, PyAny>>,
    stabilizer: Option<&Stabilizer>,
) -> PyResult<Bound<'py, PyDict>> {
    let given = [
        Some(mass),
        damping,
        stiffness,
        position,
        velocity,
        Some(wall_stiffness),
        wall_damping,
        wall_position,
    ];
    let mut told = Vec::new();
    for (value, name) in given.into_iter().zip(NAMES) {
        told.push(Numbers::of(value, name)?);
    }
    let counts: Vec<usize> = told.iter().filter_map(Numbers::count).collect();
    let loops = counts.first().copied().unwrap_or(1);
    if loops == 0 || counts.iter().any(|count| *count != loops) {
        return Err(PyValueError::new_err(format!(
            "arrays of {counts:?} loops; give all the same length of 1 or more, or floats"
        )));
    }
    let recipe = match stabilizer {
        Some(stabilizer) if stabilizer.count() != 1 || stabilizer.recipe.object.is_some() => {
            return Err(errors::input(
                "closed loops have one axis and a candidate in Rust\n  = make the stabilizer with axes=1, and credit a damping",
            ));
        }
        Some(stabilizer) => stabilizer.recipe.again(py),
        None => Recipe::of("none", None)?,
    };
    let told = told.iter().map(Numbers::slice).collect::<PyResult<Vec<_>>>()?;
    let pool = pool()?;
    let loops = Loops { told: &told, loops, ticks, period };
    let ends = py.detach(|| pool.install(|| under(&loops, &recipe))).map_err(errors::parameter)?;
    let results = PyDict::new(py);
    for (name, numbers) in RESULTS.into_iter().zip(ends) {
        results.set_item(name, array(py, numbers, &[loops.loops])?)?;
    }
    Ok(results)
}

/// The results of each loop, in this order.
const RESULTS: [&str; 4] = ["position", "velocity", "observed_energy", "largest"];

/// A number for all loops, or one for each.
enum Numbers<'py> {
    All([f64; 1]),
    Each(Given<'py>),
}

impl<'py> Numbers<'py> {
    fn of(value: Option<&Bound<'py, PyAny>>, name: &'static str) -> PyResult<Self> {
        let Some(value) = value else { return Ok(Self::All([0.0])) };
        if let Ok(number) = value.extract::<f64>() {
            return Ok(Self::All([number]));
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

    fn slice(&self) -> PyResult<Told<'_>> {
        Ok(match self {
            Self::All(number) => Told::All(number[0]),
            Self::Each(given) => Told::Each(given.numbers()?),
        })
    }
}

/// The same, of which threads take their share.
#[derive(Clone, Copy)]
enum Told<'a> {
    All(f64),
    Each(&'a [f64]),
}

impl Told<'_> {
    /// The numbers of a group.
    fn group(self, first: usize, count: usize) -> F64x8 {
        match self {
            Self::All(number) => F64x8::of(number),
            Self::Each(numbers) => F64x8::gather(&numbers[first..first + count], count),
        }
    }
}

/// The loops.
struct Loops<'a> {
    told: &'a [Told<'a>],
    loops: usize,
    ticks: u64,
    period: f64,
}

/// The ends of all loops under the stabilizer of a recipe.
fn under(loops: &Loops<'_>, recipe: &Recipe) -> Result<[Vec<f64>; 4], ParameterError> {
    let damper = || Ok((PortEnergy, Dissipation::of(F64x8::of(recipe.damping.unwrap_or(0.0)))?));
    let member: Member<F64x8> = recipe.make(damper)?;
    // The usual ones are compiled for their type, so that no tick asks which it is.
    match member {
        Member::NoStabilizer(_) => ends(loops, NoStabilizer),
        Member::Popc(popc) => ends(loops, popc),
        Member::Lolc(lolc) => ends(loops, lolc),
        member => ends(loops, member),
    }
}

fn ends<S: Step<F64x8> + Copy + Send + Sync>(
    loops: &Loops<'_>,
    stabilizer: S,
) -> Result<[Vec<f64>; 4], ParameterError> {
    let mut ends: [Vec<f64>; 4] = std::array::from_fn(|_| vec![0.0; loops.loops]);
    let [position, velocity, observed_energy, largest] = &mut ends;
    let width = BESIDE * LANES;
    let rows = position
        .par_chunks_mut(width)
        .zip(velocity.par_chunks_mut(width))
        .zip(observed_energy.par_chunks_mut(width))
        .zip(largest.par_chunks_mut(width));
    rows.enumerate().try_for_each(|(at, (((position, velocity), observed_energy), largest))| {
        let (first, count) = (at * width, position.len());
        let starts = (first..first + count).step_by(LANES);
        let groups = starts.map(|start| loops.group(start, (first + count - start).min(LANES)));
        let mut groups = groups.collect::<Result<Vec<_>, _>>()?;
        pulp::Arch::new().dispatch(Ticks { groups: &mut groups, stabilizer, ticks: loops.ticks });
        let mut rows =
            [position, velocity, observed_energy, largest].map(|it| it.chunks_mut(LANES));
        for group in groups {
            let told = [
                group.sample.position,
                group.sample.velocity,
                group.observed_energy,
                group.largest,
            ];
            for (row, numbers) in rows.iter_mut().zip(told) {
                numbers.scatter(row.next().unwrap_or_default());
            }
        }
        Ok::<(), ParameterError>(())
    })?;
    Ok(ends)
}

/// Eight loops.
struct Group {
    plant: Body<F64x8>,
    wall: Wall<F64x8>,
    sample: PortSample<F64x8>,
    observed_energy: F64x8,
    largest: F64x8,
}

impl Loops<'_> {
    fn group(&self, first: usize, count: usize) -> Result<Group, ParameterError> {
        let number = |index: usize| self.told[index].group(first, count);
        let impedance = Impedance { mass: number(0), damping: number(1), stiffness: number(2) };
        let plant = Body::new(impedance, F64x8::of(self.period))?.starting(number(3), number(4));
        let wall = Wall::new(number(5), number(6))?.at(number(7));
        let zero = F64x8::of(0.0);
        Ok(Group { plant, wall, sample: plant.start(), observed_energy: zero, largest: zero })
    }
}

/// The ticks of groups beside each other, on the instructions that the processor has.
struct Ticks<'a, S> {
    groups: &'a mut [Group],
    stabilizer: S,
    ticks: u64,
}

impl<S: Step<F64x8> + Copy> pulp::NullaryFnOnce for Ticks<'_, S> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self { groups, stabilizer, ticks } = self;
        let mut ports: Vec<_> =
            groups.iter().map(|group| group.wall.stabilized(stabilizer).differenced()).collect();
        for tick in 0..ticks {
            let late = F64x8::of(if 2 * tick >= ticks { 1.0 } else { 0.0 });
            for (group, port) in groups.iter_mut().zip(&mut ports) {
                let effort = port.respond(&group.sample);
                group.sample = group.plant.advance(effort);
                group.largest = group.largest.larger(group.sample.position.magnitude() * late);
            }
        }
        for (group, port) in groups.iter_mut().zip(&ports) {
            group.observed_energy = port.correction().observed_energy;
        }
    }
}
