//! Chaining: what changes a stabilizer owns it.

use lyapunov_core::{ParameterError, Scalar, Signal};

use crate::{Account, Bounded, ContactReset, Lolc, PerAxis, RateLimit, Rise, Spread, Threshold};

/// What may be added to a stabilizer, chained like iterator adaptors; what is not written costs nothing.
///
/// What changes the account comes first, what shapes the correction after it:
///
/// ```
/// use lyapunov_core::PortEnergy;
/// use lyapunov_stabilizers::{DampingLimit, Popc, Refine};
/// let popc = Popc::new(PortEnergy, DampingLimit::of_mass(0.5, 0.2, 1e-3)?);
/// let gentle = popc.bounded(1e-3)?.spread_over(5)?.rate_limited(2000.0)?;
/// # let _: &dyn lyapunov_core::Stabilizer<f64> = &gentle;
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
///
/// A stabilizer of one's own joins by `impl Refine for Mine {}`, and by [`Account`] if it has credit.
pub trait Refine: Sized {
    /// Carries at most `most` joules of credit from tick to tick.
    ///
    /// # Errors
    /// `most` below 0 or NaN.
    fn bounded<T: Scalar>(self, most: T) -> Result<Bounded<Self, T>, ParameterError>
    where
        Self: Account<T>,
    {
        Bounded::new(self, most)
    }

    /// Forgets its credit wherever `gate` opens.
    fn reset_at<G, T: Scalar>(self, gate: G) -> ContactReset<Self, G, T>
    where
        Self: Account<T>,
    {
        ContactReset::new(self, gate)
    }

    /// Corrects only from `velocity` m/s on.
    ///
    /// # Errors
    /// `velocity` below 0, infinite or NaN, or its square out of range.
    fn above_velocity<T: Scalar>(self, velocity: T) -> Result<Threshold<Self, T>, ParameterError> {
        Threshold::new(self, velocity)
    }

    /// Pays a debt in `ticks` parts.
    ///
    /// # Errors
    /// `ticks` is 0.
    fn spread_over<T: Scalar>(self, ticks: u32) -> Result<Spread<Self, T>, ParameterError> {
        Spread::new(self, ticks)
    }

    /// Lets the correction rise over the first `ticks` ticks of each engagement.
    ///
    /// # Errors
    /// `ticks` is 0.
    fn rising_over<T: Scalar>(self, ticks: u32) -> Result<Rise<Self, T>, ParameterError> {
        Rise::new(self, ticks)
    }

    /// Lets the correction grow by at most `rate` N/s on each axis.
    ///
    /// # Errors
    /// `rate` below 0 or NaN.
    fn rate_limited<V: Signal>(
        self,
        rate: V::Scalar,
    ) -> Result<RateLimit<Self, V>, ParameterError> {
        RateLimit::new(self, rate)
    }
}

impl<T, C, W, A> Refine for Lolc<T, C, W, A> {}
impl<S, const N: usize> Refine for PerAxis<S, N> {}
impl<S, T> Refine for Bounded<S, T> {}
impl<S, G, T: Scalar> Refine for ContactReset<S, G, T> {}
impl<S, T> Refine for Threshold<S, T> {}
impl<S, T> Refine for Spread<S, T> {}
impl<S, T> Refine for Rise<S, T> {}
impl<S, V: Signal> Refine for RateLimit<S, V> {}
