//! Stabilizer of one loop.

use std::sync::Arc;

use lyapunov::stabilizers::{Member, MemberState, NoStabilizer};
use lyapunov::{Signal, Snapshot, Stabilizer as _};
use pyo3::gc::{PyTraverseError, PyVisit};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};

use super::deep_copy::{Asking, deep_copy};
use super::{Candidate, Correction, Raised, Recipe, Sample, seen, taken};
use crate::axes::{Axes, on_any_axes, whatever_axes, with_axes};
use crate::errors::{self, of_class};
use crate::stored;
use crate::whole;

/// Member of the family with any candidate.
type Made<V> = Member<V, Candidate>;

/// Maker of the correction of a sample and an effort.
type Stabilize<'a, V> =
    dyn FnMut(&lyapunov::PortSample<V>, V) -> PyResult<lyapunov::Correction<V>> + 'a;

on_any_axes! {
    /// A stabilizer, whatever its axes.
    #[derive(Debug)]
    enum AnyMember of Made
}

/// Stabilizer of one port, by a name of docs/family.md, in a loop of your own.
///
/// `Stabilizer("popc", limit=100.0)`, `Stabilizer("lolc", limit=100.0, damping=0.1, axes=3)`. Numbers are in SI units:
///
/// - `none`
/// - `popc`: limit
/// - `lolc`: limit, and damping that the device surely has, or `candidate=it`, an object whose method `decrease(sample)`
///   returns joules, `sample.work` and what it credits besides: a call into Python on every tick, slow
/// - `popc-bounded`: limit, credit
/// - `popc-windowed`, `popc-spread`, `popc-rising`: limit, ticks
/// - `popc-threshold`: limit, velocity
/// - `popc-rate-limited`: limit, rate
/// - `force-bound`, `force-bounding`: damping
/// - `tank`: start, floor (0), ceiling (inf), power (inf)
/// - `energy-bounding`: c1, c2; it relies on a damping of c1 T, with the longest time T that a sample spans
/// - `least-norm`: limit, decay
/// - `slope-bound`: slope
///
/// `limit` N·s/m (see `damping_limit`), `damping` N·s/m, `credit`, `start`, `floor` and `ceiling` J, `power` W, `velocity`
/// m/s, `rate` N/s, `slope`, `c1` and `c2` N/m, `decay` 1/tick (at most 1), `ticks` whole.
///
/// One stabilizer belongs to one loop: a call while another is under way raises RuntimeError.
#[pyclass(module = "lyapunov")]
#[derive(Debug)]
pub(crate) struct Stabilizer {
    member: AnyMember,
    pub(crate) recipe: Recipe,
    raised: Raised,
}

impl Stabilizer {
    fn of(recipe: Recipe, axes: usize) -> PyResult<Self> {
        let raised = Raised::default();
        let member = with_axes!(axes, AnyMember, V => made::<V>(&recipe, &raised)?)?;
        Ok(Self { member, recipe, raised })
    }

    /// One of the same numbers that has summed nothing.
    pub(crate) fn fresh(&self, py: Python<'_>) -> PyResult<Self> {
        Self::of(self.recipe.again(py), self.count())
    }

    /// The number of axes.
    pub(crate) fn count(&self) -> usize {
        self.member.axes()
    }

    /// Runs `stabilize` of the member over samples of `V`, those of a recorded log.
    pub(crate) fn with_member<V: Axes, R>(
        &mut self,
        run: impl FnOnce(&mut Stabilize<'_, V>) -> PyResult<R>,
    ) -> PyResult<R> {
        let member = V::member(&mut self.member)?;
        let (asks_python, raised) = (self.recipe.object.is_some(), &self.raised);
        run(&mut |sample, effort| {
            let corrected = member.stabilize(sample, effort);
            if asks_python {
                raised.check()?;
            }
            Ok(corrected)
        })
    }
}

/// The stabilizer of a recipe.
fn made<V: Signal<Scalar = f64>>(recipe: &Recipe, raised: &Raised) -> PyResult<Made<V>> {
    // It is made first, as it may be one of Python's.
    let candidate = Recipe::candidate(recipe.damping, recipe.object.clone(), raised)?;
    recipe.make(|| Ok(candidate)).map_err(errors::parameter)
}

#[pymethods]
impl Stabilizer {
    #[new]
    #[pyo3(signature = (name, *, axes=1, **numbers))]
    fn new(
        name: &str,
        #[pyo3(from_py_with = whole::axes)] axes: usize,
        numbers: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        Self::of(Recipe::of(name, numbers)?, axes)
    }

    /// The name.
    #[getter]
    fn name(slf: &Bound<'_, Self>) -> PyResult<&'static str> {
        Ok(seen(slf)?.recipe.name)
    }

    /// The number of axes.
    #[getter]
    fn axes(slf: &Bound<'_, Self>) -> PyResult<usize> {
        Ok(seen(slf)?.count())
    }

    /// The correction of `effort`, N, a float or an array of shape (axes,), with which a controller answers `sample`.
    ///
    /// The effort resists motion, `m ẍ = … − effort`. A sample that is not finite is rejected: the correction is then 0 and
    /// not `accepted`.
    fn stabilize(
        slf: &Bound<'_, Self>,
        sample: &Bound<'_, PyAny>,
        effort: &Bound<'_, PyAny>,
    ) -> PyResult<Correction> {
        let sample: &Sample = of_class(sample, "sample")?.get();
        let this = &mut *taken(slf)?;
        let corrected =
            whatever_axes!(&mut this.member, AnyMember, it => corrected(it, sample, effort)?);
        if this.recipe.object.is_some() {
            this.raised.check()?;
        }
        Ok(corrected)
    }

    /// Forgets all that it has summed: credit is forfeited, a debt forgiven.
    fn reset(slf: &Bound<'_, Self>) -> PyResult<()> {
        let mut this = taken(slf)?;
        let fresh = this.fresh(slf.py())?;
        *this = fresh;
        Ok(())
    }

    /// A copy with the same memory.
    fn __copy__(slf: &Bound<'_, Self>) -> PyResult<Self> {
        seen(slf)?.copied(slf.py())
    }

    fn __deepcopy__<'py>(
        slf: &Bound<'py, Self>,
        memo: &Bound<'py, PyDict>,
    ) -> PyResult<Bound<'py, Self>> {
        deep_copy(slf, memo)
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let (py, this) = (slf.py(), seen(slf)?);
        let arguments = this.recipe.arguments(py)?;
        let memory = PyBytes::new(py, &this.memory()?);
        let parts = (this.recipe.name, this.count(), arguments, memory);
        stored::again(slf, parts)
    }

    #[staticmethod]
    fn _restored(
        name: &str,
        axes: usize,
        numbers: &Bound<'_, PyDict>,
        memory: &[u8],
    ) -> PyResult<Self> {
        let mut made = Self::new(name, axes, Some(numbers))?;
        made.remember(memory)?;
        Ok(made)
    }

    fn __traverse__(&self, visit: PyVisit<'_>) -> Result<(), PyTraverseError> {
        visit.call(self.recipe.object.as_deref())
    }

    fn __clear__(&mut self) {
        // The member and the recipe both hold the candidate, which may hold this block: both let it go.
        let none = with_axes!(self.count(), AnyMember, V => Made::<V>::NoStabilizer(NoStabilizer));
        self.member = none.expect("axes that the block has");
        self.recipe = Recipe { name: "none", numbers: Vec::new(), damping: None, object: None };
    }

    fn __repr__(slf: &Bound<'_, Self>) -> PyResult<String> {
        let this = seen(slf)?;
        let mut text = format!("Stabilizer({:?}", this.recipe.name);
        for (key, value) in this.recipe.arguments(slf.py())? {
            text += &format!(", {key}={}", value.repr()?);
        }
        Ok(if this.count() > 1 { format!("{text}, axes={})", this.count()) } else { text + ")" })
    }
}

impl Asking for Stabilizer {
    fn copied(&self, py: Python<'_>) -> PyResult<Self> {
        let mut copy = Self::of(self.recipe.again(py), self.count())?;
        copy.remember(&self.memory()?)?;
        Ok(copy)
    }

    fn asked(&self) -> Option<&Py<PyAny>> {
        self.recipe.object.as_deref()
    }

    fn ask(&mut self, candidate: Py<PyAny>) -> PyResult<()> {
        self.recipe.object = Some(Arc::new(candidate));
        self.remember(&self.memory()?)
    }
}

impl Stabilizer {
    /// The memory as bytes that keep every bit.
    fn memory(&self) -> PyResult<Vec<u8>> {
        whatever_axes!(&self.member, AnyMember, it => stored::write(&it.state()))
    }

    fn remember(&mut self, memory: &[u8]) -> PyResult<()> {
        let axes = self.count();
        let raised = self.raised.clone();
        let recipe = &self.recipe;
        self.member =
            with_axes!(axes, AnyMember, V => restored::<V>(made::<V>(recipe, &raised)?, memory)?)?;
        Ok(())
    }
}

fn restored<V: Axes>(member: Made<V>, memory: &[u8]) -> PyResult<Made<V>> {
    let state: MemberState<V, Candidate> = stored::read(memory)?;
    member.restored(state).map_err(errors::parameter)
}

#[inline]
fn corrected<V: Axes>(
    member: &mut Made<V>,
    sample: &Sample,
    effort: &Bound<'_, PyAny>,
) -> PyResult<Correction> {
    let sample = V::of_sample(&sample.0)?;
    let effort = V::read(effort, "effort")?;
    Ok(Correction(V::correction(member.stabilize(&sample.sample, effort))))
}
