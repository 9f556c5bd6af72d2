//! Rectangular pulse.

use lyapunov_core::{ParameterError, Requirement, Scalar};

use super::clock::Clock;
use crate::Trajectory;

/// `value` from the tick of `start` to before the tick of `start + duration`, else 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pulse {
    value: f64,
    from: u64,
    until: u64,
}

impl Pulse {
    /// A pulse of `value` from `start` s on, for `duration` s.
    ///
    /// # Errors
    /// `value` or `start` infinite or NaN; `duration` below 0, infinite or NaN; a servo rate not above 0 and finite.
    pub fn new(
        value: f64,
        start: f64,
        duration: f64,
        servo_rate: f64,
    ) -> Result<Self, ParameterError> {
        let clock = Clock::new(servo_rate)?;
        let start = Requirement::Finite.check("start", start)?;
        let duration = Requirement::NonNegative.check("duration", duration)?;
        Ok(Self {
            value: Requirement::Finite.check("value", value)?,
            from: clock.tick_of(start),
            until: clock.tick_of(start + duration),
        })
    }
}

impl<T: Scalar> Trajectory<T> for Pulse {
    #[inline]
    fn at(&self, tick: u64) -> T {
        T::of(if (self.from..self.until).contains(&tick) { self.value } else { 0.0 })
    }
}
