//! Plausible samples: limits of what a device can do, stated by the caller.

use lyapunov_core::{
    Correction, ParameterError, PortSample, Requirement, Scalar, Signal, Snapshot, Stabilizer,
};

use crate::StabilizerExt;
use crate::account::lends;

/// Largest speed and effort that a device and its environment can have, on each axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plausibility<T> {
    /// Largest speed, m/s; infinity: no limit.
    pub speed: T,
    /// Largest effort, of the environment and of the actuator, N; infinity: no limit.
    pub effort: T,
}

impl<T: Scalar> Plausibility<T> {
    /// The same limits, checked.
    fn checked(self) -> Result<Self, ParameterError> {
        Requirement::Limit.check("plausible speed", self.speed)?;
        Requirement::Limit.check("plausible effort", self.effort)?;
        Ok(self)
    }
}

/// Stabilizer that sees plausible samples only: what no device can do is rejected as a NaN is.
///
/// A field that is finite and absurd, as a flipped bit of a message makes it, is worse than a NaN: one work of 1e36 J in
/// an account of `f32`, or 1e292 J in a compensated one of `f64`, is credit for ever, and every later work is rounded off
/// beside it. Only the caller knows what is absurd, hence the limits are stated and have no default.
///
/// ```text
/// |v| ≤ speed,   |Δx| ≤ speed · T,   |f_act| ≤ effort,   |work| ≤ effort · speed · T        on each axis
/// ```
///
/// Where one is broken, the stabilizer inside gets a NaN as work and velocity: it rejects the tick and its account stays
/// as it was. What really crossed the port on that tick is lost to the account; put [readings](lyapunov_core::Readings)
/// with their `no_faster_than` or a guard in front where the next sample shall span it. Where the environment's effort
/// alone is too large, the work is booked and that effort is not passed on. Take limits that nothing real reaches: a
/// sample that was only unexpected has to be booked. It belongs outside the shaping and inside a
/// [watchdog](crate::Watchdog).
///
/// ```
/// use lyapunov_core::{HeldTick, PortEnergy, PortSample, Stabilizer};
/// use lyapunov_stabilizers::{Account, DampingLimit, Plausibility, Popc, StabilizerExt};
/// let popc = Popc::new(PortEnergy, DampingLimit::of_mass(0.5_f32, 0.2, 1e-3)?);
/// let mut popc = popc.plausible(Plausibility { speed: 5.0, effort: 100.0 })?;
/// let absurd = PortSample { work: f32::MAX, ..PortSample::starting(1e-3, 0.0, 0.1) };
/// assert!(!popc.stabilize(&absurd, 1.0).accepted && popc.observed_energy() == 0.0);
/// let gave = HeldTick {
///     period: 1e-3, position: 0.0, velocity: -0.1_f32, displacement: -1e-4, applied: 2.0,
/// };
/// assert!(popc.stabilize(&gave.sample(), 2.0).alpha > 0.0); // not blind to the next debt
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Plausible<S, T> {
    stabilizer: S,
    limits: Plausibility<T>,
}

impl<S, T: Scalar> Plausible<S, T> {
    pub(crate) fn new(stabilizer: S, limits: Plausibility<T>) -> Result<Self, ParameterError> {
        Ok(Self { stabilizer, limits: limits.checked()? })
    }
}

impl<S, T> StabilizerExt for Plausible<S, T> {}

/// Mask of the lanes with an axis beyond `most`; a NaN is not, and is left to the stabilizer inside.
#[inline(always)]
fn beyond<V: Signal>(signal: V, most: V::Scalar) -> <V::Scalar as Scalar>::Mask {
    let (zero, one) = (V::Scalar::of(0.0), V::Scalar::of(1.0));
    let count = signal.map(|axis| V::Scalar::choose(axis.magnitude().above(most), one, zero));
    count.sum().above(zero)
}

impl<V: Signal, S: Stabilizer<V>> Stabilizer<V> for Plausible<S, V::Scalar> {
    #[inline]
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let Plausibility { speed, effort: strongest } = self.limits;
        let reach = speed * sample.period;
        let absurd = beyond(sample.velocity, speed)
            | beyond(sample.displacement, reach)
            | beyond(sample.applied, strongest)
            | beyond(sample.work, strongest * reach);
        let nothing = V::splat(V::Scalar::of(f64::NAN));
        let seen = PortSample {
            velocity: V::choose(absurd, nothing, sample.velocity),
            work: V::choose(absurd, nothing, sample.work),
            ..*sample
        };
        let refused = absurd | beyond(effort, strongest);
        self.stabilizer.stabilize(&seen, V::choose(refused, nothing, effort))
    }
}

lends!(impl[S, T: Scalar] Plausible<S, T>, of S, in T);

impl<S, T: Scalar> Plausible<S, T> {
    /// The limits.
    pub fn plausibility(&self) -> Plausibility<T> {
        self.limits
    }

    /// Changes the limits between ticks; no sum changes.
    ///
    /// # Errors
    /// A limit below 0 or NaN; the old ones stay.
    pub fn set_plausibility(&mut self, limits: Plausibility<T>) -> Result<(), ParameterError> {
        self.limits = limits.checked()?;
        Ok(())
    }
}

impl<S: Snapshot, T> Snapshot for Plausible<S, T> {
    type State = S::State;

    fn state(&self) -> Self::State {
        self.stabilizer.state()
    }

    fn restored(self, inside: Self::State) -> Result<Self, ParameterError> {
        Ok(Self { stabilizer: self.stabilizer.restored(inside)?, ..self })
    }
}
