//! Chaining of stabilizers: each adaptor owns the stabilizer that it changes.

use lyapunov_core::{ParameterError, Scalar, Signal};

use crate::{
    BoundedCredit, ContactReset, LimitCredit, Plausibility, Plausible, RateLimit, SoftStart,
    Spread, VelocityThreshold, Watchdog, WatchdogTimes,
};

/// Adaptors of a stabilizer, chained like iterator adaptors; an adaptor that is absent costs nothing.
///
/// First come the adaptors that limit the credit, then those that shape the correction, then
/// the limits of what a sample can be, then a watchdog:
///
/// ```
/// use lyapunov_core::PortEnergy;
/// use lyapunov_stabilizers::{DampingLimit, Popc, StabilizerExt};
/// let popc = Popc::new(PortEnergy, DampingLimit::of_mass(0.5, 0.2, 1e-3)?);
/// let gentle = popc.bounded(1e-3)?.spread_over(5)?.rate_limited(2000.0)?;
/// # let _: &dyn lyapunov_core::Stabilizer<f64> = &gentle;
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
///
/// A stabilizer of your own joins by `impl StabilizerExt for Mine {}`, by [`LimitCredit`] if it has credit, and by
/// [`Account`](crate::Account) if that can be read.
pub trait StabilizerExt: Sized {
    /// The same stabilizer, which carries at most `most` joules of credit from tick to tick.
    ///
    /// # Errors
    /// `most` below 0 or NaN.
    fn bounded<T: Scalar>(self, most: T) -> Result<BoundedCredit<Self, T>, ParameterError>
    where
        Self: LimitCredit<T>,
    {
        BoundedCredit::new(self, most)
    }

    /// The same stabilizer, which forfeits its stored credit whenever `gate` opens.
    #[must_use]
    fn reset_at<G, T: Scalar>(self, gate: G) -> ContactReset<Self, G, T>
    where
        Self: LimitCredit<T>,
    {
        ContactReset::new(self, gate)
    }

    /// The same stabilizer, which corrects only from `velocity` m/s on.
    ///
    /// # Errors
    /// `velocity` below 0, infinite or NaN, or its square out of range.
    fn above_velocity<T: Scalar>(
        self,
        velocity: T,
    ) -> Result<VelocityThreshold<Self, T>, ParameterError> {
        VelocityThreshold::new(self, velocity)
    }

    /// The same stabilizer, which pays a debt in `ticks` parts.
    ///
    /// # Errors
    /// `ticks` is 0.
    fn spread_over<T: Scalar>(self, ticks: u32) -> Result<Spread<Self, T>, ParameterError> {
        Spread::new(self, ticks)
    }

    /// The same stabilizer, with a correction that rises over the first `ticks` ticks of each engagement.
    ///
    /// # Errors
    /// `ticks` is 0, or more than the scalar can count.
    fn rising_over<T: Scalar>(self, ticks: u32) -> Result<SoftStart<Self, T>, ParameterError> {
        SoftStart::new(self, ticks)
    }

    /// The same stabilizer, with a correction that grows by at most `rate` N/s on each axis.
    ///
    /// # Errors
    /// `rate` below 0 or NaN.
    fn rate_limited<V: Signal>(
        self,
        rate: V::Scalar,
    ) -> Result<RateLimit<Self, V>, ParameterError> {
        RateLimit::new(self, rate)
    }

    /// The same stabilizer, which rejects samples and efforts that no device can have.
    ///
    /// # Errors
    /// A limit below 0 or NaN.
    fn plausible<T: Scalar>(
        self,
        limits: Plausibility<T>,
    ) -> Result<Plausible<Self, T>, ParameterError> {
        Plausible::new(self, limits)
    }

    /// The same stabilizer, which holds its last effort without sound samples and then lets go, and whose environment
    /// rises at the start; outermost.
    ///
    /// # Errors
    /// `hold` below 0 or NaN; `rise` below 0, infinite or NaN.
    fn watched<V: Signal>(
        self,
        times: WatchdogTimes<V::Scalar>,
    ) -> Result<Watchdog<Self, V>, ParameterError> {
        Watchdog::new(self, times)
    }
}

/// ```
/// use lyapunov_core::{PortEnergy, PortSample, Stabilizer};
/// use lyapunov_stabilizers::{DampingLimit, Popc, StabilizerExt};
/// let popc = Popc::new(PortEnergy, DampingLimit::of_mass(0.5, 0.2, 1e-3)?);
/// let chosen: Box<dyn Stabilizer<f64>> = Box::new(popc);
/// let mut gentle = chosen.spread_over(5)?;
/// assert_eq!(gentle.stabilize(&PortSample::starting(1e-3, 0.0, 0.0), 2.0).effort, 2.0);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[cfg(feature = "alloc")]
impl<S: ?Sized> StabilizerExt for alloc::boxed::Box<S> {}

/// A stabilizer that is lent keeps what it sums.
///
/// ```
/// use lyapunov_core::{PortEnergy, PortSample, Stabilizer};
/// use lyapunov_stabilizers::{Account, DampingLimit, Popc, StabilizerExt};
/// let mut popc = Popc::new(PortEnergy, DampingLimit::of_mass(0.5, 0.2, 1e-3)?).budgeted(3e-4)?;
/// (&mut popc).bounded(1e-4)?.stabilize(&PortSample::starting(1e-3, 0.0, 0.0), 0.0);
/// assert_eq!(popc.observed_energy(), 1e-4);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
impl<S: ?Sized> StabilizerExt for &mut S {}
