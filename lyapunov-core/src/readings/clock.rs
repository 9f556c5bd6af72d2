//! The time between readings: one period, or that of a clock.

use super::{CheckedSample, Measured, MovingReading, Reading, Readings, Track};
use crate::{Mask, ParameterError, Requirement, Scalar, Signal, Snapshot, VelocityEstimator};

/// Readings at a fixed period: every call is one tick.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Steady;

/// Readings at the times of a clock that the caller reads, in seconds from any start.
///
/// The times are `f64` whatever the port's scalar, so that a year still has nanoseconds, and one clock serves all lanes.
/// A time that cannot be one between two readings counts as one period, is reported ([`CheckedSample::timed`]), and spoils no
/// later one; where the clock goes on by a period, it is that of the first lane:
///
/// | time of a reading | counts as | the clock is taken to have gone on |
/// |---|---|---|
/// | the first one | a period | from there |
/// | later than where the clock was taken to be, by more than half a period if it stood before | the time between | from there |
/// | NaN or infinite | a period | by a period |
/// | the same as the last, as of a clock too coarse | a period | by a period |
/// | any other: a clock set back, a counter that overflowed, hardly more or less than was counted while it stood | a period | from there |
///
/// A clock that stood goes on by the rest of what was counted for it, which may be arbitrarily short: a displacement
/// over so short a time would be a velocity without bound.
///
/// ```
/// use lyapunov_core::{Reading, Readings};
/// let mut readings = Readings::every(1e-3)?.clocked();
/// let mut period = |now| {
///     let told = readings.read_at(now, Reading { position: 0.0_f64, applied: 0.0 });
///     (1e3 * told.sample.period, told.timed)
/// };
/// assert_eq!(period(5.000), (1.0, true));
/// assert_eq!(period(f64::NAN), (1.0, false));
/// assert_eq!(period(2.000), (1.0, false)); // set back
/// let (late, timed) = period(2.002);
/// assert!((late - 2.0).abs() < 1e-9 && timed);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
///
/// Held work does not depend on time at all; the credit of a damper, and what a correction is said to dissipate, do.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Clocked {
    last: Option<Times>,
}

/// Two times of a clock, s.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Times {
    /// The last time told.
    told: f64,
    /// The time that the periods told so far reach: beyond `told` while the clock stands.
    reached: f64,
}

impl Clocked {
    /// The time from the last reading to `now`, s, and whether it is known; else it is a `period`.
    #[inline]
    fn elapsed<T: Scalar>(&mut self, now: f64, period: T) -> (T, bool) {
        let Some(Times { told, reached }) = self.last else {
            self.last = now.is_finite().then_some(Times { told: now, reached: now });
            return (period, self.last.is_some());
        };
        let elapsed = T::of(now - reached);
        let least = if reached > told { 0.5 * period.lane(0) } else { 0.0 };
        let forth = now > reached && elapsed.lane(0) > least && elapsed.lane(0).is_finite();
        let stands = now == told || !now.is_finite();
        let told = if now.is_finite() { now } else { told };
        let reached = if stands { reached + period.lane(0) } else { now };
        self.last = Some(Times { told, reached });
        (T::choose(Mask::of(forth), elapsed, period), forth)
    }
}

impl Snapshot for Clocked {
    /// The last time told, and the time that the periods reach.
    type State = Option<[f64; 2]>;

    fn state(&self) -> Self::State {
        self.last.map(|Times { told, reached }| [told, reached])
    }

    fn restored(self, last: Self::State) -> Result<Self, ParameterError> {
        let last = match last {
            None => None,
            Some([told, reached]) => {
                let told = Requirement::Finite.check("stored time", told)?;
                let reached = Requirement::AtLeast(told).check("stored time reached", reached)?;
                Some(Times { told, reached })
            }
        };
        Ok(Self { last })
    }
}

impl<V: Signal, E: VelocityEstimator<V>, P: Track<V>> Readings<V, E, Steady, P> {
    /// The sample of this tick's reading.
    #[inline(always)]
    pub fn read(&mut self, reading: Reading<V, P::Place>) -> CheckedSample<V> {
        self.hear(self.period, true, reading)
    }

    /// The sample of a tick without a reading, over which the effort `applied` acted.
    ///
    /// ```
    /// use lyapunov_core::{Reading, Readings};
    /// let mut readings = Readings::every(1e-3)?;
    /// readings.read(Reading { position: 0.0_f64, applied: 0.0 });
    /// assert!(!readings.missed(2.0).accepted);
    /// let gap = readings.read(Reading { position: 2e-3, applied: 2.0 }).sample;
    /// assert_eq!((gap.period, gap.work, gap.velocity), (2e-3, 4e-3, 1.0)); // 2 N held over 2 mm
    /// # Ok::<(), lyapunov_core::ParameterError>(())
    /// ```
    #[inline]
    pub fn missed(&mut self, applied: V) -> CheckedSample<V> {
        self.read(Reading { position: P::nowhere(), applied })
    }
}

impl<V: Signal, E: VelocityEstimator<V>, P: Track<V>> Readings<V, E, Clocked, P> {
    /// The sample of the reading at the time `now`, s.
    #[inline]
    pub fn read_at(&mut self, now: f64, reading: Reading<V, P::Place>) -> CheckedSample<V> {
        let (elapsed, timed) = self.clock.elapsed(now, self.period);
        self.hear(elapsed, timed, reading)
    }

    /// The sample of a tick without a reading at the time `now`, s, before which the effort `applied` acted.
    #[inline]
    pub fn missed_at(&mut self, now: f64, applied: V) -> CheckedSample<V> {
        self.read_at(now, Reading { position: P::nowhere(), applied })
    }
}

impl<V: Signal, P: Track<V>> Readings<V, Measured, Steady, P> {
    /// The sample of this tick's reading.
    #[inline(always)]
    pub fn read_moving(&mut self, reading: MovingReading<V, P::Place>) -> CheckedSample<V> {
        self.hear_moving(self.period, true, reading)
    }

    /// The sample of a tick without a reading, over which the effort `applied` acted.
    #[inline]
    pub fn missed_moving(&mut self, applied: V) -> CheckedSample<V> {
        self.read_moving(MovingReading { position: P::nowhere(), velocity: V::zero(), applied })
    }
}

impl<V: Signal, P: Track<V>> Readings<V, Measured, Clocked, P> {
    /// The sample of the reading at the time `now`, s.
    #[inline]
    pub fn read_moving_at(
        &mut self,
        now: f64,
        reading: MovingReading<V, P::Place>,
    ) -> CheckedSample<V> {
        let (elapsed, timed) = self.clock.elapsed(now, self.period);
        self.hear_moving(elapsed, timed, reading)
    }

    /// The sample of a tick without a reading at the time `now`, s, before which the effort `applied` acted.
    #[inline]
    pub fn missed_moving_at(&mut self, now: f64, applied: V) -> CheckedSample<V> {
        let reading = MovingReading { position: P::nowhere(), velocity: V::zero(), applied };
        self.read_moving_at(now, reading)
    }
}
