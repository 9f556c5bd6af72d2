//! Memory of a port: readings in, samples out.

use lyapunov::readings::{Clocked, Differenced, LowPassed, Measured, Steady};
use lyapunov::{CheckedSample, MovingReading, PortSample, Reading, Readings as Memory, Snapshot};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use super::{Sample, seen, taken};
use crate::axes::{Axes, on_any_axes, whatever_axes, with_axes};
use crate::errors;
use crate::number;
use crate::stored;
use crate::whole;

/// The readings with each estimator of the velocity, with and without a clock.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Kinds<V: lyapunov::Signal> {
    Differenced(Memory<V, Differenced, Steady>),
    LowPassed(Memory<V, LowPassed<V>, Steady>),
    Measured(Memory<V, Measured, Steady>),
    DifferencedAt(Memory<V, Differenced, Clocked>),
    LowPassedAt(Memory<V, LowPassed<V>, Clocked>),
    MeasuredAt(Memory<V, Measured, Clocked>),
}

on_any_axes! {
    /// Readings, whatever their axes.
    #[derive(Clone, Copy, Debug)]
    enum AnyReadings of Kinds
}

/// An expression of the memory, whatever its kind.
macro_rules! whatever_kind {
    ($value:expr, $inner:ident => $expression:expr) => {
        match $value {
            Kinds::Differenced($inner) => $expression,
            Kinds::LowPassed($inner) => $expression,
            Kinds::Measured($inner) => $expression,
            Kinds::DifferencedAt($inner) => $expression,
            Kinds::LowPassedAt($inner) => $expression,
            Kinds::MeasuredAt($inner) => $expression,
        }
    };
}

/// What readings are made of.
#[derive(Clone, Copy, Debug)]
struct Made {
    period: f64,
    fastest: Option<f64>,
    cutoff: Option<f64>,
    measured: bool,
    clocked: bool,
}

impl Made {
    fn kinds<V: Axes>(self) -> PyResult<Kinds<V>> {
        let memory = Memory::<V>::every(self.period).map_err(errors::parameter)?;
        let memory = match self.fastest {
            Some(fastest) => memory.no_faster_than(fastest).map_err(errors::parameter)?,
            None => memory,
        };
        Ok(match (self.cutoff, self.measured, self.clocked) {
            (Some(_), true, _) => {
                return Err(errors::input(
                    "cutoff and measured exclude each other\n  = leave cutoff out where the device measures its velocity",
                ));
            }
            (None, false, false) => Kinds::Differenced(memory),
            (None, false, true) => Kinds::DifferencedAt(memory.clocked()),
            (None, true, false) => Kinds::Measured(memory.measured()),
            (None, true, true) => Kinds::MeasuredAt(memory.measured().clocked()),
            (Some(cutoff), false, false) => {
                Kinds::LowPassed(memory.low_passed(cutoff).map_err(errors::parameter)?)
            }
            (Some(cutoff), false, true) => {
                Kinds::LowPassedAt(memory.low_passed(cutoff).map_err(errors::parameter)?.clocked())
            }
        })
    }
}

/// Memory of a port in a loop of your own: readings of a device in, samples for stabilizers out.
///
/// `Readings(period, *, axes=1, no_faster_than=None, cutoff=None, measured=False, clocked=False)`: `period` between two
/// ticks, s; `no_faster_than`, m/s, the fastest motion there can be: what only a faster one could reach is rejected, and
/// the next reading spans the gap. Velocities are differences of positions, or low-passed at `cutoff`, Hz, or `measured`.
/// With `clocked`, time is what the caller reads from a clock.
#[pyclass(module = "lyapunov")]
#[derive(Debug)]
pub(crate) struct Readings {
    pub(crate) readings: AnyReadings,
    made: Made,
}

#[pymethods]
impl Readings {
    #[new]
    #[pyo3(signature = (period, *, axes=1, no_faster_than=None, cutoff=None, measured=false, clocked=false))]
    fn new(
        #[pyo3(from_py_with = number::period)] period: f64,
        #[pyo3(from_py_with = whole::axes)] axes: usize,
        #[pyo3(from_py_with = number::no_faster_than_if_any)] no_faster_than: Option<f64>,
        #[pyo3(from_py_with = number::cutoff_if_any)] cutoff: Option<f64>,
        #[pyo3(from_py_with = number::measured)] measured: bool,
        #[pyo3(from_py_with = number::clocked)] clocked: bool,
    ) -> PyResult<Self> {
        let made = Made { period, fastest: no_faster_than, cutoff, measured, clocked };
        let readings = with_axes!(axes, AnyReadings, V => made.kinds::<V>()?)?;
        Ok(Self { readings, made })
    }

    /// The sample of a reading.
    ///
    /// `position`, m, and `applied`, N, the effort that the motors really applied since the last reading: floats, or arrays
    /// of shape (axes,); `velocity`, m/s, where it is measured; `now`, s, where there is a clock. A `position` of None is a
    /// tick without a reading.
    #[pyo3(signature = (position, applied, *, velocity=None, now=None))]
    fn read(
        slf: &Bound<'_, Self>,
        position: &Bound<'_, PyAny>,
        applied: &Bound<'_, PyAny>,
        velocity: Option<&Bound<'_, PyAny>>,
        #[pyo3(from_py_with = number::now_if_any)] now: Option<f64>,
    ) -> PyResult<Sample> {
        let this = &mut *taken(slf)?;
        whatever_axes!(&mut this.readings, AnyReadings, it => sample(it, position, applied, velocity, now))
    }

    /// Forgets the position: the next reading displaces nothing, as the first.
    fn restart(slf: &Bound<'_, Self>) -> PyResult<()> {
        let this = &mut *taken(slf)?;
        whatever_axes!(&mut this.readings, AnyReadings, it => whatever_kind!(it, it => it.restart()));
        Ok(())
    }

    /// The period, s.
    #[getter]
    fn period(&self) -> f64 {
        whatever_axes!(&self.readings, AnyReadings, it => whatever_kind!(it, it => it.period()))
    }

    /// The number of axes.
    #[getter]
    fn axes(&self) -> usize {
        self.readings.axes()
    }

    fn __copy__(&self) -> Self {
        Self { readings: self.readings, made: self.made }
    }

    fn __deepcopy__(&self, _memo: &Bound<'_, PyAny>) -> Self {
        self.__copy__()
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let (py, this) = (slf.py(), seen(slf)?);
        let Made { period, fastest, cutoff, measured, clocked } = this.made;
        let memory = PyBytes::new(py, &this.memory()?);
        let made = (period, this.axes(), fastest, cutoff, measured, clocked);
        stored::again(slf, (made, memory))
    }

    #[staticmethod]
    fn _restored(
        made: (f64, usize, Option<f64>, Option<f64>, bool, bool),
        memory: &[u8],
    ) -> PyResult<Self> {
        let (period, axes, fastest, cutoff, measured, clocked) = made;
        let Self { made, .. } = Self::new(period, axes, fastest, cutoff, measured, clocked)?;
        let readings =
            with_axes!(axes, AnyReadings, V => restored::<V>(made.kinds::<V>()?, memory)?)?;
        Ok(Self { readings, made })
    }

    fn __repr__(&self) -> String {
        let Made { period, fastest, cutoff, measured, clocked } = self.made;
        let mut text = format!("Readings(period={period:?}, axes={}", self.axes());
        for (name, number) in [("no_faster_than", fastest), ("cutoff", cutoff)] {
            if let Some(number) = number {
                text += &format!(", {name}={number:?}");
            }
        }
        for (name, is_so) in [("measured", measured), ("clocked", clocked)] {
            text += &if is_so { format!(", {name}=True") } else { String::new() };
        }
        text + ")"
    }
}

impl Readings {
    fn memory(&self) -> PyResult<Vec<u8>> {
        whatever_axes!(&self.readings, AnyReadings, it => {
            whatever_kind!(it, it => stored::write(&it.state()))
        })
    }
}

impl<V: Axes> Kinds<V> {
    /// The sample of a reading, where neither a velocity nor a time belongs to it.
    pub(crate) fn read_plain(&mut self, position: V, applied: V) -> PyResult<PortSample<V>> {
        match self {
            Self::Differenced(it) => Ok(it.read(Reading { position, applied }).sample),
            Self::LowPassed(it) => Ok(it.read(Reading { position, applied }).sample),
            _ => Err(errors::input(
                "recorded ticks have neither a velocity nor a time\n  = make the readings without measured= and clocked=",
            )),
        }
    }
}

fn restored<V: Axes>(kinds: Kinds<V>, memory: &[u8]) -> PyResult<Kinds<V>> {
    macro_rules! each {
        ($($kind:ident),+) => {
            match kinds {
                $(Kinds::$kind(fresh) => {
                    let state = stored::read(memory)?;
                    Kinds::$kind(fresh.restored(state).map_err(errors::parameter)?)
                })+
            }
        };
    }
    Ok(each!(Differenced, LowPassed, Measured, DifferencedAt, LowPassedAt, MeasuredAt))
}

#[inline]
fn sample<V: Axes>(
    kinds: &mut Kinds<V>,
    position: &Bound<'_, PyAny>,
    applied: &Bound<'_, PyAny>,
    velocity: Option<&Bound<'_, PyAny>>,
    now: Option<f64>,
) -> PyResult<Sample> {
    if velocity.is_some() && !matches!(kinds, Kinds::Measured(_) | Kinds::MeasuredAt(_)) {
        return Err(errors::input(
            "a velocity is given, which these readings estimate themselves\n  = leave velocity out, or make them with \
             measured=True",
        ));
    }
    if now.is_some()
        && matches!(kinds, Kinds::Differenced(_) | Kinds::LowPassed(_) | Kinds::Measured(_))
    {
        return Err(errors::input(
            "a time is given, and these readings have no clock\n  = leave now out, or make them with clocked=True",
        ));
    }
    // A position that is not finite is no reading.
    let position = match position.is_none() {
        true => V::from_axes(|_| f64::NAN),
        false => V::read(position, "position")?,
    };
    let applied = V::read(applied, "applied")?;
    let reading = Reading { position, applied };
    let moving = |velocity: Option<&Bound<'_, PyAny>>| -> PyResult<MovingReading<V>> {
        let velocity = velocity.ok_or_else(|| {
            errors::input(
                "the velocity is missing\n  = give velocity=…, as these readings are measured=True",
            )
        })?;
        Ok(MovingReading { position, velocity: V::read(velocity, "velocity")?, applied })
    };
    let time = || {
        now.ok_or_else(|| {
            errors::input(
                "the time is missing\n  = give now=…, in s, as these readings are clocked=True",
            )
        })
    };
    let told: CheckedSample<V> = match kinds {
        Kinds::Differenced(it) => it.read(reading),
        Kinds::LowPassed(it) => it.read(reading),
        Kinds::Measured(it) => it.read_moving(moving(velocity)?),
        Kinds::DifferencedAt(it) => it.read_at(time()?, reading),
        Kinds::LowPassedAt(it) => it.read_at(time()?, reading),
        Kinds::MeasuredAt(it) => it.read_moving_at(time()?, moving(velocity)?),
    };
    Ok(Sample(V::sample(told)))
}
