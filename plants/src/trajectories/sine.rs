//! Sine.

use core::f64::consts::TAU;

use lyapunov_core::{ParameterError, Requirement, Scalar};

use super::clock::Clock;
use crate::Trajectory;

/// `about + amplitude sin(2π frequency t_n)`.
///
/// Whole turns are removed before they can cost digits: the sine of the thousandth turn is as accurate as that of the
/// first.
///
/// ```
/// use lyapunov_plants::{Sine, Trajectory};
/// let sway = Sine::new(0.1, 0.02, 0.5, 1000.0)?; // about, amplitude, Hz, rate of the servo
/// let quarter: f64 = sway.at(500);
/// assert!((quarter - 0.12).abs() < 1e-15);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sine {
    about: f64,
    amplitude: f64,
    frequency: f64,
    clock: Clock,
}

impl Sine {
    /// A sine of `amplitude` about `about`, at `frequency` Hz.
    ///
    /// # Errors
    /// `about` or `amplitude` infinite, NaN, or together out of range; `frequency` below 0, infinite or NaN; a servo
    /// rate not above 0 and finite.
    pub fn new(
        about: f64,
        amplitude: f64,
        frequency: f64,
        servo_rate: f64,
    ) -> Result<Self, ParameterError> {
        Requirement::Finite.check("about", about)?;
        Requirement::Finite.check("amplitude", amplitude)?;
        let reach = about.abs() + amplitude.abs();
        Requirement::InRange.require("amplitude", amplitude, reach.is_finite())?;
        let frequency = Requirement::NonNegative.check("frequency", frequency)?;
        Ok(Self { about, amplitude, frequency, clock: Clock::new(servo_rate)? })
    }

    /// The fraction of a turn at `tick`, within ±1/2 up to a rounding.
    fn turn(&self, tick: u64) -> f64 {
        let time = self.clock.time(tick);
        let turns = self.frequency * time;
        let lacking =
            libm::fma(self.frequency, time, -turns) + self.frequency * self.clock.lacking(tick);
        let part = |turns: f64| turns - libm::round(turns);
        let turn = part(part(turns) + part(lacking));
        // A number of turns that is not finite has no fraction.
        if turn.is_finite() { turn } else { 0.0 }
    }
}

impl<T: Scalar> Trajectory<T> for Sine {
    #[inline]
    fn at(&self, tick: u64) -> T {
        T::of(self.about + self.amplitude * libm::sin(TAU * self.turn(tick)))
    }
}
