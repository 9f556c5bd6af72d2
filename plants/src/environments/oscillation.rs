//! What swings with the time of its own calls.

use core::f64::consts::TAU;

use lyapunov_core::{ParameterError, Requirement, Scalar};

/// `amplitude sin(2π frequency t(n))` with `t(n) = n / rate`, `n` the calls before this one.
///
/// Time is made anew from the count on every call and never summed. The phase is `2π · (frequency · (n / rate))`
/// in `f64`, each operation rounded once, so it is off by no more than four roundings of its own size: 3e-12 rad
/// after a thousand turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Oscillation<T> {
    amplitude: T,
    frequency: T,
    rate: T,
    calls: u64,
}

impl<T: Scalar> Oscillation<T> {
    pub(super) fn new(amplitude: T, frequency: T, rate: T) -> Result<Self, ParameterError> {
        let amplitude = Requirement::Finite.check("amplitude", amplitude)?;
        let frequency = Requirement::NonNegative.check("frequency", frequency)?;
        let rate = Requirement::Positive.check("rate", rate)?;
        let oscillation = Self { amplitude, frequency, rate, calls: 0 };
        let at_last = Self { calls: u64::MAX, ..oscillation };
        let peak = T::from_lanes(|lane| oscillation.peak_slope(lane));
        let out_of_range =
            |&lane: &usize| !(at_last.phase(lane).is_finite() && peak.lane(lane).is_finite());
        match (0..T::LANES).find(out_of_range) {
            None => Ok(oscillation),
            Some(lane) => Err(ParameterError {
                parameter: "frequency",
                value: frequency.lane(lane),
                requirement: Requirement::InRange,
            }),
        }
    }

    /// The same from its first call on, called at `rate` Hz.
    pub(super) fn called_at(&self, rate: T) -> Result<Self, ParameterError> {
        Self::new(self.amplitude, self.frequency, rate)
    }

    #[inline]
    pub(super) fn value(&self) -> T {
        T::from_lanes(|lane| self.amplitude.lane(lane) * libm::sin(self.phase(lane)))
    }

    /// How fast the value changes, per s.
    #[inline]
    pub(super) fn slope(&self) -> T {
        T::from_lanes(|lane| self.peak_slope(lane) * libm::cos(self.phase(lane)))
    }

    #[inline]
    pub(super) fn advance(&mut self) {
        self.calls += 1;
    }

    #[inline]
    fn phase(&self, lane: usize) -> f64 {
        TAU * (self.frequency.lane(lane) * (self.calls as f64 / self.rate.lane(lane)))
    }

    #[inline]
    fn peak_slope(&self, lane: usize) -> f64 {
        TAU * self.frequency.lane(lane) * self.amplitude.lane(lane)
    }
}
