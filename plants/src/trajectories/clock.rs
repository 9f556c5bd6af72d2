//! Instants and ticks.

use lyapunov_core::{ParameterError, Requirement};

/// The tick from which on `instant`, s, counts: `ceil(p − 1e-9)` of `p = instant · servo_rate`, or `ceil(p − 2 ε p)` where that is
/// less.
///
/// The billionth of a tick lets an instant that is meant to fall on a tick do so: 0.3 s at 10 Hz is tick 3, though
/// rounding may put the product above 3. After some million ticks rounding is more than a billionth. An instant below 0
/// or NaN is tick 0, and one that is too large the last tick.
///
/// ```
/// use lyapunov_plants::tick_of;
/// assert_eq!(tick_of(0.3, 10.0), 3);
/// assert_eq!(tick_of(0.31, 10.0), 4);
/// ```
pub fn tick_of(instant: f64, servo_rate: f64) -> u64 {
    // A conversion from a float saturates.
    let product = instant * servo_rate;
    libm::ceil((product - 1e-9).min(product * (1.0 - 2.0 * f64::EPSILON))) as u64
}

/// Clock of a servo rate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Clock {
    rate: f64,
}

impl Clock {
    pub(super) fn new(servo_rate: f64) -> Result<Self, ParameterError> {
        let rate = Requirement::Positive.check("servo rate", servo_rate)?;
        Ok(Self { rate })
    }

    /// `t_n = n / servo_rate`, s.
    pub(super) fn time(self, tick: u64) -> f64 {
        (tick as f64 / self.rate).min(f64::MAX)
    }

    /// The rounding error of `t_n`, which added to it gives `n / servo_rate`, s.
    pub(super) fn lacking(self, tick: u64) -> f64 {
        -libm::fma(self.time(tick), self.rate, -(tick as f64)) / self.rate
    }

    pub(super) fn tick_of(self, instant: f64) -> u64 {
        tick_of(instant, self.rate)
    }
}
