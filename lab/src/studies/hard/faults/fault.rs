//! Fault of a tick.

use std::fmt;

use lyapunov::{PortSample, Scalar, Signal};

/// Number of a tick that a fault can spoil.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Field {
    /// The period.
    Period,
    /// The position.
    Position,
    /// The velocity.
    Velocity,
    /// The displacement.
    Displacement,
    /// The effort that was applied.
    Applied,
    /// The work.
    Work,
    /// The effort that is asked.
    Effort,
}

/// Fault of a tick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fault {
    /// A number in place of a field, on every axis.
    Number(Field, f64),
    /// A field with its sign turned; a period below 0 is a clock that runs backwards.
    Mirrored(Field),
    /// The motion of the tick before once more. The next sample spans both.
    Stale,
    /// The whole sample of the tick before once more; the one of this tick is lost.
    Repeated,
    /// A tick that does not reach the stabilizer, while its last force acts on. The next sample spans both.
    Dropped,
    /// A sample that comes 0.9 of a period late, so that the next one seems to come after 0.1 of one.
    Late,
}

impl Field {
    const ALL: [Self; 7] = [
        Self::Period,
        Self::Position,
        Self::Velocity,
        Self::Displacement,
        Self::Applied,
        Self::Work,
        Self::Effort,
    ];
}

impl Fault {
    /// All of them.
    pub fn all() -> Vec<Self> {
        let numbers = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
        let spoilt = |field| numbers.map(|number| Self::Number(field, number));
        let mut faults = vec![Self::Stale, Self::Repeated, Self::Dropped, Self::Late];
        faults.push(Self::Number(Field::Period, 0.0));
        faults.extend(Field::ALL.map(Self::Mirrored));
        faults.extend(Field::ALL.into_iter().flat_map(spoilt));
        faults
    }

    /// The field and its change, where the fault is one of a number.
    fn change<T: Scalar>(self) -> Option<(Field, impl Fn(T) -> T)> {
        let (field, put) = match self {
            Self::Number(field, number) => (field, Some(number)),
            Self::Mirrored(field) => (field, None),
            Self::Stale | Self::Repeated | Self::Dropped | Self::Late => return None,
        };
        Some((field, move |axis: T| put.map_or(T::of(0.0) - axis, T::of)))
    }

    /// The effort that is asked under the fault.
    pub(super) fn asked<V: Signal>(self, effort: V) -> V {
        match self.change::<V::Scalar>() {
            Some((Field::Effort, change)) => effort.map(change),
            _ => effort,
        }
    }

    /// The sample with one of its numbers spoilt.
    pub(super) fn spoilt<V: Signal>(self, mut sample: PortSample<V>) -> PortSample<V> {
        if let Some((field, change)) = self.change::<V::Scalar>() {
            match field {
                Field::Period => sample.period = change(sample.period),
                Field::Position => sample.position = sample.position.map(change),
                Field::Velocity => sample.velocity = sample.velocity.map(change),
                Field::Displacement => sample.displacement = sample.displacement.map(change),
                Field::Applied => sample.applied = sample.applied.map(change),
                Field::Work => sample.work = sample.work.map(change),
                Field::Effort => {}
            }
        }
        sample
    }
}

impl fmt::Display for Field {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Period => "period",
            Self::Position => "position",
            Self::Velocity => "velocity",
            Self::Displacement => "displacement",
            Self::Applied => "applied force",
            Self::Work => "work",
            Self::Effort => "asked force",
        })
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(field, number) => write!(f, "a {field} of {number}"),
            Self::Mirrored(field) => write!(f, "a {field} with its sign turned"),
            Self::Stale => f.write_str("a stale motion"),
            Self::Repeated => f.write_str("a repeated sample"),
            Self::Dropped => f.write_str("a dropped tick"),
            Self::Late => f.write_str("a late sample"),
        }
    }
}
