//! Watchdog: what a loop commands while it hears nothing, and how it comes back.

use lyapunov_core::{
    Correction, ParameterError, PortSample, Requirement, Scalar, Signal, Snapshot, Stabilizer,
};

use crate::account::lends;

/// Times of a [`Watchdog`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WatchdogTimes<T> {
    /// Time for which the last effort is held without a sound sample, s; infinity: without end.
    pub hold: T,
    /// Time in which the environment's effort rises at the start and after a release, s.
    pub rise: T,
}

impl<T: Scalar> WatchdogTimes<T> {
    /// The same times, checked.
    fn checked(self) -> Result<Self, ParameterError> {
        Requirement::Limit.check("watchdog hold", self.hold)?;
        Requirement::NonNegative.check("watchdog rise", self.rise)?;
        Ok(self)
    }
}

/// Stabilizer with a watchdog: without sound samples it holds the last effort for a while and then lets go, and it
/// comes back gently.
///
/// ```text
/// silence(n) = silence(n−1) + T                         where the sample or the correction is not accepted, else 0
/// F(n)       = F(n−1)  while silence ≤ hold + T / 16,  0  beyond: the sum is rounded, and a hold of n periods is one of n ticks
/// share(n)   = min(1, risen(n) / rise),   risen(n) = risen(n−1) + max(0, T − silence(n−1)),  from 0 at the start and at
///              each release: a sample that spans a gap has the time of the silence in it
/// F(n)       = what the stabilizer inside makes of share · f,  where accepted
/// ```
///
/// The share is of the environment's effort and not of the correction: damping acts in full from the first tick. A
/// sample is not sound if a field is not finite, as that of a reading which
/// [`Readings`](lyapunov_core::Readings) did not accept; a tick of unknown length, also one of a clock that stands or
/// steps back, ends the hold. The wall that rises
/// gives energy as any environment does that changes by itself; what crosses the port is booked. Report the effort that
/// was applied on every tick, the held one too, and the sample that spans the gap books it.
///
/// While it rises or holds it keeps neither [`Opposes`](lyapunov_core::laws::Law::Opposes) nor
/// [`NoLarger`](lyapunov_core::laws::Law::NoLarger): it may let less of a braking force through, or hold one
/// that the motion has turned against. Keep the hold as short as the shortest gap that is normal. It belongs outermost.
/// Times of 0 change no bit of a sound run.
///
/// ```
/// use lyapunov_core::{PortEnergy, Reading, Readings, Stabilizer};
/// use lyapunov_stabilizers::{DampingLimit, Popc, StabilizerExt, WatchdogTimes};
/// let popc = Popc::new(PortEnergy, DampingLimit::of_mass(0.5, 0.2, 1e-3)?);
/// let mut popc = popc.watched::<f64>(WatchdogTimes { hold: 2e-3, rise: 0.0 })?;
/// let mut readings = Readings::every(1e-3)?;
/// let mut applied = 0.0;
/// let efforts = [1e-3, f64::NAN, f64::NAN, f64::NAN, 1e-3].map(|position| {
///     let sample = readings.read(Reading { position, applied }).sample;
///     applied = popc.stabilize(&sample, 8e3 * sample.position).effort;
///     applied
/// });
/// assert_eq!(efforts, [8.0, 8.0, 8.0, 0.0, 8.0]);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Watchdog<S, V: Signal> {
    stabilizer: S,
    times: WatchdogTimes<V::Scalar>,
    effort: V,
    silence: V::Scalar,
    risen: V::Scalar,
}

impl<S, V: Signal> Watchdog<S, V> {
    pub(crate) fn new(
        stabilizer: S,
        times: WatchdogTimes<V::Scalar>,
    ) -> Result<Self, ParameterError> {
        let times = times.checked()?;
        let zero = V::Scalar::of(0.0);
        Ok(Self { stabilizer, times, effort: V::zero(), silence: zero, risen: zero })
    }
}

impl<V: Signal, S: Stabilizer<V>> Stabilizer<V> for Watchdog<S, V> {
    #[inline]
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let choose = <V::Scalar as Signal>::choose;
        let (zero, one) = (V::Scalar::of(0.0), V::Scalar::of(1.0));
        let WatchdogTimes { hold, rise } = self.times;
        // A sample that spans a gap has the time of the silence in it.
        let tick = (sample.period - self.silence).larger(zero);
        let risen = (self.risen + tick).smaller(rise);
        let share = choose(risen.below(rise), risen / rise, one);
        let correction = self.stabilizer.stabilize(sample, effort.scale(share));

        let accepted = correction.accepted & sample.sound();
        let known = sample.timed();
        let endless = V::Scalar::largest();
        let quiet = choose(known, sample.period, endless);
        self.silence = choose(accepted, zero, (self.silence + quiet).smaller(endless));
        let rounding = quiet * V::Scalar::of(1.0 / 16.0);
        let held = !self.silence.above(hold + rounding);
        self.risen = choose(accepted, risen, choose(held, self.risen, zero));
        let fallback = V::choose(held, self.effort, V::zero());
        self.effort = V::choose(accepted, correction.effort, fallback);
        let debt = (-correction.observed_energy).larger(zero);
        Correction {
            effort: self.effort,
            alpha: choose(accepted, correction.alpha, zero),
            shortfall: choose(accepted, correction.shortfall, debt),
            accepted,
            ..correction
        }
    }
}

lends!(impl[S, V: Signal] Watchdog<S, V>, of S, in V::Scalar);

impl<S, V: Signal> Watchdog<S, V> {
    /// Times for which it holds and in which the environment rises.
    pub fn times(&self) -> WatchdogTimes<V::Scalar> {
        self.times
    }

    /// Changes the times between ticks; a hold or a rise under way goes on with the new ones.
    ///
    /// # Errors
    /// `hold` below 0 or NaN; `rise` below 0, infinite or NaN; the old ones stay.
    pub fn set_times(&mut self, times: WatchdogTimes<V::Scalar>) -> Result<(), ParameterError> {
        self.times = times.checked()?;
        Ok(())
    }
}

impl<S: Snapshot, V: Signal> Snapshot for Watchdog<S, V> {
    /// The memory of the stabilizer inside, the last effort, N, the silence since, s, and how long the environment has risen, s.
    type State = (S::State, V, V::Scalar, V::Scalar);

    fn state(&self) -> Self::State {
        (self.stabilizer.state(), self.effort, self.silence, self.risen)
    }

    fn restored(
        self,
        (inside, effort, silence, risen): Self::State,
    ) -> Result<Self, ParameterError> {
        let effort = Requirement::Finite.check_axes("stored effort", effort)?;
        let silence = Requirement::NonNegative.check("stored silence", silence)?;
        let risen = Requirement::NonNegative.check("stored rise", risen)?;
        Ok(Self { stabilizer: self.stabilizer.restored(inside)?, effort, silence, risen, ..self })
    }
}
