//! Oscillation timed by the count of its own calls.

use core::f64::consts::TAU;

use lyapunov_core::{ParameterError, Requirement, Scalar};

use crate::Time;

/// `amplitude sin(2π frequency t)`, sampled at `t(n) = n / rate` with `n` the number of earlier calls.
///
/// Every call computes the time from the count, never by summing. The phase is `2π · (frequency · t)` in `f64`, each
/// operation rounded once, so its error is at most four roundings of its own size: 3e-12 rad after a thousand turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Oscillation<T> {
    amplitude: T,
    frequency: T,
    rate: T,
    calls: u64,
}

impl<T: Scalar> Oscillation<T> {
    /// The number of calls so far.
    pub(super) fn calls(&self) -> u64 {
        self.calls
    }

    /// The same oscillation after so many calls.
    pub(super) fn after(self, calls: u64) -> Self {
        Self { calls, ..self }
    }

    pub(super) fn new(amplitude: T, frequency: T, rate: T) -> Result<Self, ParameterError> {
        let amplitude = Requirement::Finite.check("amplitude", amplitude)?;
        let frequency = Requirement::NonNegative.check("frequency", frequency)?;
        let rate = Requirement::Positive.check("rate", rate)?;
        let oscillation = Self { amplitude, frequency, rate, calls: 0 };
        let last = Time::Calls { number: u64::MAX, rate };
        let peak = T::from_lanes(|lane| oscillation.peak_slope(lane));
        // Of `f64`: the phase is never rounded to the scalar.
        let counts = |lane| f64::from(u8::from(oscillation.phase(last, lane).is_finite()));
        let kept = peak.finite() & T::from_lanes(counts).above(T::of(0.0));
        Requirement::InRange.require("frequency", frequency, kept).map(|()| oscillation)
    }

    /// The same oscillation from its first call on, called at `rate` Hz.
    pub(super) fn called_at(&self, rate: T) -> Result<Self, ParameterError> {
        Self::new(self.amplitude, self.frequency, rate)
    }

    /// The time of this call; the next one is a step later.
    #[inline]
    pub(super) fn tick(&mut self) -> Time<T> {
        let now = Time::Calls { number: self.calls, rate: self.rate };
        self.calls = self.calls.wrapping_add(1);
        now
    }

    #[inline]
    pub(super) fn value(&self, time: Time<T>) -> T {
        T::from_lanes(|lane| self.amplitude.lane(lane) * libm::sin(self.phase(time, lane)))
    }

    /// The rate of change of the value, per s.
    #[inline]
    pub(super) fn slope(&self, time: Time<T>) -> T {
        T::from_lanes(|lane| self.peak_slope(lane) * libm::cos(self.phase(time, lane)))
    }

    #[inline]
    fn phase(&self, time: Time<T>, lane: usize) -> f64 {
        TAU * (self.frequency.lane(lane) * time.seconds(lane))
    }

    #[inline]
    fn peak_slope(&self, lane: usize) -> f64 {
        TAU * self.frequency.lane(lane) * self.amplitude.lane(lane)
    }
}
