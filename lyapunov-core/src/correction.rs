//! What a stabilizer did on one tick.

use crate::{Mask, Scalar, Signal};

/// What a stabilizer did on one tick: telemetry without strings.
#[derive(Clone, Copy, Debug)]
pub struct Correction<V: Signal> {
    /// The effort to command, correction included, N.
    pub effort: V,
    /// The observer sum `L(n)` before this tick's correction, J.
    pub observed_energy: V::Scalar,
    /// The damping injected on this tick, N·s/m; of a stabilizer that corrects in another way, 0.
    pub alpha: V::Scalar,
    /// The debt that this tick's correction cannot serve, J; it stays in the sum.
    pub shortfall: V::Scalar,
    /// Where the sample was accepted; elsewhere a stabilizer gives a zero effort, a guard its fallback.
    pub accepted: <V::Scalar as Scalar>::Mask,
}

impl<V: Signal> PartialEq for Correction<V> {
    fn eq(&self, other: &Self) -> bool {
        self.effort == other.effort
            && self.observed_energy == other.observed_energy
            && self.alpha == other.alpha
            && self.shortfall == other.shortfall
            && self.accepted_alike(other)
    }
}

impl<V: Signal> Correction<V> {
    /// Whether both accept the same lanes.
    pub(crate) fn accepted_alike(&self, other: &Self) -> bool {
        (0..V::Scalar::LANES).all(|lane| self.accepted.lane(lane) == other.accepted.lane(lane))
    }

    /// What a port without a stabilizer reports: `effort` as it is, and nothing done.
    #[inline(always)]
    pub fn none(effort: V) -> Self {
        let zero = V::Scalar::of(0.0);
        Self {
            effort,
            observed_energy: zero,
            alpha: zero,
            shortfall: zero,
            accepted: Mask::of(true),
        }
    }

    /// This correction if its effort is finite; elsewhere a zero effort without damping, not accepted.
    #[inline(always)]
    pub fn checked(self) -> Self {
        let finite = self.effort.finite();
        Self {
            effort: V::choose(finite, self.effort, V::zero()),
            alpha: V::Scalar::choose(finite, self.alpha, V::Scalar::of(0.0)),
            accepted: self.accepted & finite,
            ..self
        }
    }
}
