//! Ramp from one value to another at a given rate.

use lyapunov_core::{ParameterError, Requirement, Scalar};

use super::clock::Clock;
use crate::Trajectory;

/// `from + sgn(to − from) rate (t_n − at)` from the tick of `at` on, never past `to`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ramp {
    from: f64,
    to: f64,
    rate: f64,
    at: f64,
    clock: Clock,
}

impl Ramp {
    /// A ramp from `from` to `to` at `rate` per second, from `at` s on.
    ///
    /// # Errors
    /// A value or an instant that is infinite or NaN; `rate` below 0, infinite or NaN; a servo rate not above 0 and
    /// finite.
    pub fn new(
        from: f64,
        to: f64,
        rate: f64,
        at: f64,
        servo_rate: f64,
    ) -> Result<Self, ParameterError> {
        Ok(Self {
            from: Requirement::Finite.check("from", from)?,
            to: Requirement::Finite.check("to", to)?,
            rate: Requirement::NonNegative.check("rate", rate)?,
            at: Requirement::Finite.check("at", at)?,
            clock: Clock::new(servo_rate)?,
        })
    }
}

impl<T: Scalar> Trajectory<T> for Ramp {
    #[inline]
    fn at(&self, tick: u64) -> T {
        let Self { from, to, rate, at, clock } = *self;
        if tick < clock.tick_of(at) {
            return T::of(from);
        }
        // The tick of an instant may come a billionth of a tick before it.
        let way = rate * (clock.time(tick) - at).clamp(0.0, f64::MAX);
        T::of(if to < from { (from - way).max(to) } else { (from + way).min(to) })
    }
}
