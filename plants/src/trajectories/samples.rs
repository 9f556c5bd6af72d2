//! Trajectory through the rows of a table.

use lyapunov_core::{ParameterError, Requirement, Scalar};

use super::clock::Clock;
use crate::Trajectory;

/// Rows of time, s, and value: linear between rows, constant before the first and after the last.
///
/// `R` is the table: an array, a slice or whatever owns one. Of rows with the same time the last counts from that time
/// on, so two of them make a jump.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Samples<R> {
    rows: R,
    clock: Clock,
}

impl<R: AsRef<[(f64, f64)]>> Samples<R> {
    /// The trajectory through `rows`, whose times never decrease.
    ///
    /// # Errors
    /// No rows; a time or a value that is infinite or NaN; a time below the one before it; two rows so far apart
    /// that their difference is out of range; a servo rate not above 0 and finite.
    pub fn new(rows: R, servo_rate: f64) -> Result<Self, ParameterError> {
        let clock = Clock::new(servo_rate)?;
        let table = rows.as_ref();
        Requirement::AtLeast(1.0).check("rows", table.len() as f64)?;
        let mut before = None;
        for &(time, value) in table {
            Requirement::Finite.check("t", time)?;
            Requirement::Finite.check("value", value)?;
            if let Some((earlier, last)) = before {
                Requirement::AtLeast(earlier).check("t", time)?;
                Requirement::InRange.require("t", time, f64::is_finite(time - earlier))?;
                Requirement::InRange.require("value", value, f64::is_finite(value - last))?;
            }
            before = Some((time, value));
        }
        Ok(Self { rows, clock })
    }

    fn value(&self, tick: u64) -> f64 {
        let (rows, time) = (self.rows.as_ref(), self.clock.time(tick));
        let next = rows.partition_point(|row| row.0 <= time);
        let before = next.checked_sub(1).and_then(|index| rows.get(index));
        match (before, rows.get(next)) {
            (Some(&(t, value)), Some(&(later, then))) => {
                value + (then - value) * ((time - t) / (later - t))
            }
            (Some(&(_, value)), None) | (None, Some(&(_, value))) => value,
            (None, None) => 0.0,
        }
    }
}

impl<T: Scalar, R: AsRef<[(f64, f64)]>> Trajectory<T> for Samples<R> {
    #[inline]
    fn at(&self, tick: u64) -> T {
        T::of(self.value(tick))
    }
}
