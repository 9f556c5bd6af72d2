//! Soft start: corrections that rise over the first ticks of an engagement.

use lyapunov_core::{
    Correction, ParameterError, PortSample, Requirement, Scalar, Signal, Snapshot, Stabilizer,
};

use super::{portion, whole};
use crate::account::lends;

/// Stabilizer whose correction rises over the first `N` ticks of each engagement: on the `j`-th tick in debt after
/// one without, `min(1, j / N)` of it is applied.
///
/// A sudden debt would be served by an impulse; this makes the first ticks softer and the debt last longer.
/// `N = 1` changes no bit.
///
/// ```
/// use lyapunov_core::{HeldTick, PortEnergy, Stabilizer};
/// use lyapunov_stabilizers::{DampingLimit, Popc, StabilizerExt};
/// let popc = Popc::new(PortEnergy, DampingLimit::of_mass(0.5, 0.2, 1e-3)?);
/// let mut popc = popc.rising_over(4)?;
/// let sample = HeldTick { period: 1e-3, position: 0.0, velocity: 0.1, displacement: 1e-4, applied: -8.0 }.sample();
/// let first = popc.stabilize(&sample, 0.0);
/// // the same debt
/// let second = popc.stabilize(&HeldTick {
///     period: 1e-3, position: 0.0, velocity: 0.1, displacement: 1e-4, applied: 0.0
/// }.sample(), 0.0);
/// assert_eq!(second.alpha, 2.0 * first.alpha);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct SoftStart<S, T> {
    stabilizer: S,
    ticks: T,
    engaged: T,
}

/// A number of ticks to which the scalar can count in steps of 1.
fn countable<T: Scalar>(ticks: u32) -> Result<T, ParameterError> {
    let most = (T::of(2.0) / T::epsilon()).lane(0);
    Requirement::AtMost(most).check("rise ticks", f64::from(ticks))?;
    whole("rise ticks", ticks)
}

impl<S, T: Scalar> SoftStart<S, T> {
    pub(crate) fn new(stabilizer: S, ticks: u32) -> Result<Self, ParameterError> {
        let ticks = countable(ticks)?;
        Ok(Self { stabilizer, ticks, engaged: T::of(0.0) })
    }
}

impl<V: Signal, S: Stabilizer<V>> Stabilizer<V> for SoftStart<S, V::Scalar> {
    #[inline(always)]
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let (zero, one) = (V::Scalar::of(0.0), V::Scalar::of(1.0));
        let correction = self.stabilizer.stabilize(sample, effort);
        let further = (self.engaged + one).smaller(self.ticks);
        self.engaged = V::Scalar::choose(correction.observed_energy.below(zero), further, zero);
        // By division: a product with 1 / N may stay below 1 on the N-th tick.
        portion(correction, sample, effort, self.engaged / self.ticks)
    }
}

lends!(impl[S, T: Scalar] SoftStart<S, T>, of S, in T);

impl<S, T: Scalar> SoftStart<S, T> {
    /// The number of ticks.
    pub fn ticks(&self) -> u32 {
        self.ticks.lane(0) as u32
    }

    /// Changes the number of ticks; a rise under way goes on with the new number.
    ///
    /// # Errors
    /// 0 ticks, or more than the scalar can count, 2^24 in `f32`; the old number stays.
    pub fn set_ticks(&mut self, ticks: u32) -> Result<(), ParameterError> {
        self.ticks = countable(ticks)?;
        Ok(())
    }
}

impl<S: Snapshot, T: Scalar> Snapshot for SoftStart<S, T> {
    /// The memory of the stabilizer inside, and the ticks of the engagement so far.
    type State = (S::State, T);

    fn state(&self) -> Self::State {
        (self.stabilizer.state(), self.engaged)
    }

    fn restored(self, (inside, engaged): Self::State) -> Result<Self, ParameterError> {
        let engaged = Requirement::NonNegative.check("stored ticks", engaged)?;
        Ok(Self { stabilizer: self.stabilizer.restored(inside)?, engaged, ..self })
    }
}
