//! Sample of a port.

use lyapunov::{CheckedSample, HeldTick, PortSample};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::axes::{Axes, on_any_axes, whatever_axes, with_axes};
use crate::number;
use crate::stored;
use crate::whole;

on_any_axes! {
    /// A sample, whatever its axes.
    #[derive(Clone, Copy, Debug, PartialEq)]
    enum AnySample of CheckedSample
}

/// What the port's other side did since the last call, and whether its reading was accepted.
///
/// Attributes that are signals are floats on one axis and float64 arrays of shape (axes,) on several.
///
/// `Sample(period, position, velocity, displacement, applied, *, axes=1)` makes one by hand: the work is that of a force
/// that was held over the period, `applied · displacement`.
#[pyclass(module = "lyapunov", frozen, eq, skip_from_py_object)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Sample(pub(crate) AnySample);

fn by_hand<V: Axes>(period: f64, signals: [&Bound<'_, PyAny>; 4]) -> PyResult<CheckedSample<V>> {
    let [position, velocity, displacement, applied] = signals;
    let tick = HeldTick {
        period,
        position: V::read(position, "position")?,
        velocity: V::read(velocity, "velocity")?,
        displacement: V::read(displacement, "displacement")?,
        applied: V::read(applied, "applied")?,
    };
    Ok(checked(tick.sample()))
}

/// The sample as a port hands it on, without the flags of its reading: that it was accepted is seen in its numbers, and
/// whether it jumped or came late is not told.
pub(super) fn checked<V: Axes>(sample: PortSample<V>) -> CheckedSample<V> {
    let of_axes = [sample.velocity, sample.work];
    let accepted = sample.period.is_finite()
        && (0..V::COUNT).all(|axis| of_axes.iter().all(|it| it.along(axis).is_finite()));
    CheckedSample { sample, accepted, jumped: false, late: false, timed: true }
}

#[pymethods]
impl Sample {
    #[new]
    #[pyo3(signature = (period, position, velocity, displacement, applied, *, axes=1))]
    fn new(
        #[pyo3(from_py_with = number::period)] period: f64,
        position: &Bound<'_, PyAny>,
        velocity: &Bound<'_, PyAny>,
        displacement: &Bound<'_, PyAny>,
        applied: &Bound<'_, PyAny>,
        #[pyo3(from_py_with = whole::axes)] axes: usize,
    ) -> PyResult<Self> {
        let signals = [position, velocity, displacement, applied];
        with_axes!(axes, AnySample, V => by_hand::<V>(period, signals)?).map(Self)
    }

    /// The number of axes.
    #[getter]
    fn axes(&self) -> usize {
        self.0.axes()
    }

    /// Time since the last accepted reading, s; that of this tick where this reading was not accepted.
    #[getter]
    fn period(&self) -> f64 {
        whatever_axes!(&self.0, AnySample, it => it.sample.period)
    }

    /// Position now, m.
    #[getter]
    fn position<'py>(&self, py: Python<'py>) -> Bound<'py, PyAny> {
        whatever_axes!(&self.0, AnySample, it => it.sample.position.show(py))
    }

    /// Velocity now, m/s.
    #[getter]
    fn velocity<'py>(&self, py: Python<'py>) -> Bound<'py, PyAny> {
        whatever_axes!(&self.0, AnySample, it => it.sample.velocity.show(py))
    }

    /// Motion since the last accepted reading, m.
    #[getter]
    fn displacement<'py>(&self, py: Python<'py>) -> Bound<'py, PyAny> {
        whatever_axes!(&self.0, AnySample, it => it.sample.displacement.show(py))
    }

    /// Effort that acted until this reading, N.
    #[getter]
    fn applied<'py>(&self, py: Python<'py>) -> Bound<'py, PyAny> {
        whatever_axes!(&self.0, AnySample, it => it.sample.applied.show(py))
    }

    /// Work on each axis, J: `applied · displacement`, and of several efforts since the last accepted reading the least that
    /// one of them would have done over the motion since then; NaN of a reading that was not accepted.
    #[getter]
    fn work<'py>(&self, py: Python<'py>) -> Bound<'py, PyAny> {
        whatever_axes!(&self.0, AnySample, it => it.sample.work.show(py))
    }

    /// Whether the reading was accepted.
    #[getter]
    fn accepted(&self) -> bool {
        whatever_axes!(&self.0, AnySample, it => it.accepted)
    }

    /// Whether the reading lies farther away than the fastest motion leads; False where a candidate or a stabilizer in
    /// Python is asked, which is told whether the reading was accepted, and not why.
    #[getter]
    fn jumped(&self) -> bool {
        whatever_axes!(&self.0, AnySample, it => it.jumped)
    }

    /// Whether more than one and a half periods went by since the last accepted reading; False where a candidate or a
    /// stabilizer in Python is asked, which sees the period.
    #[getter]
    fn late(&self) -> bool {
        whatever_axes!(&self.0, AnySample, it => it.late)
    }

    fn __copy__(slf: Py<Self>) -> Py<Self> {
        // It never changes.
        slf
    }

    fn __deepcopy__(slf: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
        slf
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let (py, it) = (slf.py(), slf.get());
        let bytes = whatever_axes!(&it.0, AnySample, it => stored::write(it)?);
        stored::again(slf, (it.axes(), PyBytes::new(py, &bytes)))
    }

    #[staticmethod]
    fn _restored(axes: usize, bytes: &[u8]) -> PyResult<Self> {
        with_axes!(axes, AnySample, V => stored::read::<CheckedSample<V>>(bytes)?).map(Self)
    }

    fn __repr__(&self) -> String {
        whatever_axes!(&self.0, AnySample, it => format!(
            "Sample(axes={}, period={:?}, position={}, velocity={}, accepted={})",
            self.axes(),
            it.sample.period,
            shown(&it.sample.position),
            shown(&it.sample.velocity),
            if it.accepted { "True" } else { "False" },
        ))
    }
}

/// A signal as it is given: a number, or a list.
pub(super) fn shown<V: Axes>(signal: &V) -> String {
    let numbers: Vec<f64> = (0..V::COUNT).map(|axis| signal.along(axis)).collect();
    match numbers[..] {
        [number] => format!("{number:?}"),
        _ => format!("{numbers:?}"),
    }
}
