//! Plausible samples: limits of what a device can do, stated by the caller.

use lyapunov_core::{
    Correction, ParameterError, PortSample, Requirement, Scalar, Signal, Snapshot, Stabilizer,
};

use crate::account::lends;

/// Smallest period, velocity, displacement and applied effort but 0 that a stabilizer sees; of work, its square.
const LEAST: f64 = 2.0 * f64::EPSILON;

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
/// Numbers that no device can resolve are 0 to the stabilizer inside, whatever the limits: on each axis a velocity, a
/// displacement or an applied effort below 2⁻⁵¹ (4·10⁻¹⁶ m/s, m, N), a work below the square of that, and a period below
/// 2⁻⁵¹ s, which is no time then. Smaller numbers have subnormal products, for which a processor may take several times as
/// long (docs/embedded.md).
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

/// NaN where an axis is beyond `most`, else -0, which changes no number that it is added to; a NaN is not beyond.
///
/// Added, not chosen: a compiler makes a branch of several choices by one mask.
#[inline(always)]
fn beyond<V: Signal>(signal: V, most: V::Scalar) -> V::Scalar {
    let (nothing, all) = (V::Scalar::of(f64::NAN), V::Scalar::of(-0.0));
    signal.map(|axis| V::Scalar::choose(axis.magnitude().above(most), nothing, all)).sum()
}

/// The signal, with 0 on axes below `least`; a NaN stays.
#[inline(always)]
fn resolved<V: Signal>(signal: V, least: f64) -> V {
    let (zero, least) = (V::Scalar::of(0.0), V::Scalar::of(least));
    signal.map(|axis| V::Scalar::choose(axis.magnitude().below(least), zero, axis))
}

impl<V: Signal, S: Stabilizer<V>> Stabilizer<V> for Plausible<S, V::Scalar> {
    #[inline]
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let Plausibility { speed, effort: strongest } = self.limits;
        let period = resolved(sample.period, LEAST);
        let zero = V::Scalar::of(0.0);
        let reach = speed * period;
        // Whatever the effort, none of it works where nothing may move; infinity times 0 would bound nothing.
        let work = V::Scalar::choose(reach.above(zero), strongest * reach, reach);
        let absurd = beyond(sample.velocity, speed)
            + beyond(sample.displacement, reach)
            + beyond(sample.applied, strongest)
            + beyond(sample.work, work);
        let seen = PortSample {
            period,
            position: sample.position,
            velocity: resolved(sample.velocity, LEAST) + V::splat(absurd),
            displacement: resolved(sample.displacement, LEAST),
            applied: resolved(sample.applied, LEAST),
            work: resolved(sample.work, LEAST * LEAST) + V::splat(absurd),
        };
        let refused = absurd + beyond(effort, strongest);
        self.stabilizer.stabilize(&seen, effort + V::splat(refused))
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

lyapunov_core::snapshot!(impl[S: Snapshot, T] Plausible<S, T>, is stabilizer, of S::State);
