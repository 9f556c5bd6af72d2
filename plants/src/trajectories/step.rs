//! Step from one value to another.

use lyapunov_core::{ParameterError, Requirement, Scalar};

use super::clock::Clock;
use crate::Trajectory;

/// `from` before the tick of an instant, and `to` from it on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    from: f64,
    to: f64,
    tick: u64,
}

impl Step {
    /// A step from `from` to `to` at `at` s.
    ///
    /// # Errors
    /// A value or an instant that is infinite or NaN; a rate not above 0 and finite.
    pub fn new(from: f64, to: f64, at: f64, servo_rate: f64) -> Result<Self, ParameterError> {
        let clock = Clock::new(servo_rate)?;
        Ok(Self {
            from: Requirement::Finite.check("from", from)?,
            to: Requirement::Finite.check("to", to)?,
            tick: clock.tick_of(Requirement::Finite.check("at", at)?),
        })
    }
}

impl<T: Scalar> Trajectory<T> for Step {
    #[inline]
    fn at(&self, tick: u64) -> T {
        T::of(if tick < self.tick { self.from } else { self.to })
    }
}
