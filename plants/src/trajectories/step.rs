//! Step from one value to another.

use lyapunov_core::{ParameterError, Requirement, Scalar};

use super::clock::Clock;
use crate::Trajectory;

/// `from` before the tick of an instant, and `to` from it on.
///
/// ```
/// use lyapunov_plants::{Step, Trajectory};
/// let step = Step::new(0.0, 0.01, 0.5, 1000.0)?; // after half a second
/// let [before, after]: [f64; 2] = [499, 500].map(|tick| step.at(tick));
/// assert_eq!((before, after), (0.0, 0.01));
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
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
