//! Spread correction: a debt paid in instalments.

use lyapunov_core::{
    Correction, ParameterError, PortSample, Requirement, Scalar, Signal, Snapshot, Stabilizer,
};

use super::{portion, whole};
use crate::account::lends;

/// Stabilizer that pays a debt over `N` ticks instead of at once.
///
/// A tick dissipates `p(n) = max(D(n) / N, min(p(n−1), D(n)))` joules, with `D = max(0, −L)` the debt: a single debt is
/// paid in `N` equal parts, and one that grows meanwhile raises the rate. The rest of the debt is reported as
/// shortfall. `N = 1` changes no bit. The stabilizer inside must be one that reports a damping.
///
/// An instalment is the energy that the correction is meant to dissipate, `α v² T`. The next sample shows what it
/// really dissipated, and the difference is a part of the next debt.
///
/// ```
/// use approx::abs_diff_eq;
/// use lyapunov_core::{HeldTick, PortEnergy, Stabilizer};
/// use lyapunov_stabilizers::{DampingLimit, Popc, StabilizerExt};
/// let popc = Popc::new(PortEnergy, DampingLimit::of_mass(0.5, 0.2, 1e-3)?);
/// let mut popc = popc.spread_over(4)?;
/// // a debt of 0.2 mJ
/// let correction = popc.stabilize(&HeldTick {
///     period: 1e-3, position: 0.0, velocity: 0.1, displacement: 1e-4, applied: -2.0
/// }.sample(), 0.0);
/// let burnt: f64 = correction.alpha * 0.1 * 0.1 * 1e-3;
/// let left: f64 = correction.shortfall;
/// assert!(abs_diff_eq!(burnt, 0.5e-4, epsilon = 1e-15) && abs_diff_eq!(left, 1.5e-4, epsilon = 1e-15));
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Spread<S, T> {
    stabilizer: S,
    ticks: T,
    part: T,
}

impl<S, T: Scalar> Spread<S, T> {
    pub(crate) fn new(stabilizer: S, ticks: u32) -> Result<Self, ParameterError> {
        let ticks = whole("spread ticks", ticks)?;
        Ok(Self { stabilizer, ticks, part: T::of(0.0) })
    }
}

impl<V: Signal, S: Stabilizer<V>> Stabilizer<V> for Spread<S, V::Scalar> {
    #[inline(always)]
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let correction = self.stabilizer.stabilize(sample, effort);
        let debt = (-correction.observed_energy).larger(V::Scalar::of(0.0));
        self.part = (debt / self.ticks).larger(self.part.smaller(debt));
        let burnt = correction.alpha * (sample.velocity.inner(sample.velocity) * sample.period);
        // In full, the dissipated energy is the debt rounded up, which is no reason to reduce it.
        let full = burnt * (V::Scalar::of(1.0) - V::Scalar::of(16.0) * V::Scalar::epsilon());
        let one = V::Scalar::of(1.0);
        let share = V::Scalar::choose(self.part.below(full), self.part / burnt, one);
        portion(correction, sample, effort, share)
    }
}

lends!(impl[S, T: Scalar] Spread<S, T>, of S, in T);

impl<S, T: Scalar> Spread<S, T> {
    /// The number of ticks; above 2^24 in `f32` the one that the scalar holds.
    pub fn ticks(&self) -> u32 {
        self.ticks.lane(0) as u32
    }

    /// Changes the number of ticks; an instalment under way is at least as large as before.
    ///
    /// # Errors
    /// 0 ticks; the old number stays.
    pub fn set_ticks(&mut self, ticks: u32) -> Result<(), ParameterError> {
        self.ticks = whole("spread ticks", ticks)?;
        Ok(())
    }
}

impl<S: Snapshot, T: Scalar> Snapshot for Spread<S, T> {
    /// The memory of the stabilizer inside, and the part of the debt that is paid on each tick, J.
    type State = (S::State, T);

    fn state(&self) -> Self::State {
        (self.stabilizer.state(), self.part)
    }

    fn restored(self, (inside, part): Self::State) -> Result<Self, ParameterError> {
        let part = Requirement::NonNegative.check("stored instalment", part)?;
        Ok(Self { stabilizer: self.stabilizer.restored(inside)?, part, ..self })
    }
}
