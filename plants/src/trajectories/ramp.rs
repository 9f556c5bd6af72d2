//! Ramp from one value to another at a given rate.

use lyapunov_core::{ParameterError, Requirement, Scalar};

use super::clock::Clock;
use crate::Trajectory;

/// Ends, rate and beginning of a [`Ramp`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RampParts {
    /// The value before.
    pub from: f64,
    /// The value in the end.
    pub to: f64,
    /// The rate between, per second.
    pub rate: f64,
    /// The instant at which it begins, s.
    pub at: f64,
}

/// `from + sgn(to − from) rate (t_n − at)` from the tick of `at` on, never past `to`.
///
/// ```
/// use lyapunov_plants::{Ramp, RampParts, Trajectory};
/// let ramp = Ramp::new(RampParts { from: 0.0, to: 0.01, rate: 0.02, at: 0.1 }, 1000.0)?;
/// let values: [f64; 3] = [50, 200, 2000].map(|tick| ramp.at(tick));
/// assert!(values[0] == 0.0 && (values[1] - 2e-3).abs() < 1e-15 && values[2] == 0.01);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ramp {
    parts: RampParts,
    clock: Clock,
}

impl Ramp {
    /// A ramp at a servo rate, Hz.
    ///
    /// # Errors
    /// A value or an instant that is infinite or NaN; `rate` below 0, infinite or NaN; a servo rate not above 0 and
    /// finite.
    pub fn new(parts: RampParts, servo_rate: f64) -> Result<Self, ParameterError> {
        Requirement::Finite.check("from", parts.from)?;
        Requirement::Finite.check("to", parts.to)?;
        Requirement::NonNegative.check("rate", parts.rate)?;
        Requirement::Finite.check("at", parts.at)?;
        Ok(Self { parts, clock: Clock::new(servo_rate)? })
    }
}

impl<T: Scalar> Trajectory<T> for Ramp {
    #[inline]
    fn at(&self, tick: u64) -> T {
        let Self { parts: RampParts { from, to, rate, at }, clock } = *self;
        if tick < clock.tick_of(at) {
            return T::of(from);
        }
        // The tick of an instant may come a billionth of a tick before it.
        let way = rate * (clock.time(tick) - at).clamp(0.0, f64::MAX);
        T::of(if to < from { (from - way).max(to) } else { (from + way).min(to) })
    }
}
