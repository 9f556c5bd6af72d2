//! Rate limit: corrections that grow no faster than a motor follows.

use lyapunov_core::{
    Correction, ParameterError, PortSample, Requirement, Scalar, Signal, Snapshot, Stabilizer,
};

use super::{added, portion};
use crate::account::lends;

/// Stabilizer whose correction grows by at most `rate · T` newtons per tick on each axis, `rate` in N/s.
///
/// A correction `c(n)` may be as large as `|c(n−1)| + rate T` if it has the sign of the one before, and as large as
/// `rate T` if not; where an axis would be larger, all axes are reduced by one factor, so that the direction stays. It
/// may fall at any rate: a correction that outlasted its cause would push along the motion. The part held back is
/// reported as shortfall. An infinite rate changes no bit.
///
/// ```
/// use approx::assert_abs_diff_eq;
/// use lyapunov_core::{HeldTick, PortEnergy, Stabilizer};
/// use lyapunov_stabilizers::{DampingLimit, Popc, StabilizerExt};
/// let popc = Popc::new(PortEnergy, DampingLimit::of_mass(0.5, 0.2, 1e-3)?);
/// let mut popc = popc.rate_limited(500.0)?;
/// let sample = HeldTick { period: 1e-3, position: 0.0, velocity: 0.1, displacement: 1e-4, applied: -8.0 }.sample();
/// for most in [0.5, 1.0, 1.5] {
///     let effort: f64 = popc.stabilize(&sample, 0.0).effort;
///     assert_abs_diff_eq!(effort, most, epsilon = 1e-12);
/// }
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct RateLimit<S, V: Signal> {
    stabilizer: S,
    rate: V::Scalar,
    last: V,
}

impl<S, V: Signal> RateLimit<S, V> {
    pub(crate) fn new(stabilizer: S, rate: V::Scalar) -> Result<Self, ParameterError> {
        let rate = Requirement::Limit.check("correction rate", rate)?;
        Ok(Self { stabilizer, rate, last: V::zero() })
    }
}

impl<V: Signal, S: Stabilizer<V>> Stabilizer<V> for RateLimit<S, V> {
    #[inline(always)]
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let (zero, one) = (V::Scalar::of(0.0), V::Scalar::of(1.0));
        let correction = self.stabilizer.stabilize(sample, effort);
        let growth = (self.rate * sample.period).larger(zero);
        let mut share = one;
        let _ = added(&correction, effort).zip(self.last, |wanted, last| {
            let along =
                (wanted.above(zero) & last.above(zero)) | (wanted.below(zero) & last.below(zero));
            let most = V::Scalar::choose(along, last.magnitude(), zero) + growth;
            let size = wanted.magnitude();
            let own = V::Scalar::choose(size.above(most), most / size, one);
            share = share.smaller(own);
            wanted
        });
        let correction = portion(correction, sample, effort, share);
        // At the end of the range the difference of two finite efforts may round to an infinity.
        self.last = added(&correction, effort).limited(V::Scalar::largest());
        correction
    }
}

lends!(impl[S, V: Signal] RateLimit<S, V>, of S, in V::Scalar);

impl<S, V: Signal> RateLimit<S, V> {
    /// The largest growth of a correction, N/s.
    pub fn rate(&self) -> V::Scalar {
        self.rate
    }

    /// Changes the largest growth between ticks. A smaller one delays dissipation and changes no sum.
    ///
    /// # Errors
    /// `rate` below 0 or NaN; the old one stays.
    pub fn set_rate(&mut self, rate: V::Scalar) -> Result<(), ParameterError> {
        self.rate = Requirement::Limit.check("correction rate", rate)?;
        Ok(())
    }
}

impl<S: Snapshot, V: Signal> Snapshot for RateLimit<S, V> {
    /// The memory of the stabilizer inside, and what the last correction added, N.
    type State = (S::State, V);

    fn state(&self) -> Self::State {
        (self.stabilizer.state(), self.last)
    }

    fn restored(self, (inside, last): Self::State) -> Result<Self, ParameterError> {
        let last = Requirement::Finite.check_axes("stored correction", last)?;
        Ok(Self { stabilizer: self.stabilizer.restored(inside)?, last, ..self })
    }
}
