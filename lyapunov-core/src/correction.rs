//! The correction of one tick.

use crate::scalar::same_lanes;
use crate::{Mask, Scalar, Signal};

/// Correction of one tick: the effort to command, and what the stabilizer did to it, as numbers.
///
/// ```
/// use lyapunov_core::Correction;
/// let damped = Correction { alpha: 3.0, ..Correction::none(1.0 + 3.0 * 0.1) };
/// assert!(damped.accepted && damped.shortfall == 0.0);
/// // An effort that went out of range is rejected, with an effort of 0.
/// let rejected = Correction::none(f64::INFINITY).checked();
/// assert!(!rejected.accepted && rejected.effort == 0.0);
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "V: serde::Serialize, V::Scalar: serde::Serialize, \
                     <V::Scalar as Scalar>::Mask: serde::Serialize",
        deserialize = "V: serde::Deserialize<'de>, V::Scalar: serde::Deserialize<'de>, \
                       <V::Scalar as Scalar>::Mask: serde::Deserialize<'de>"
    ))
)]
pub struct Correction<V: Signal> {
    /// The effort to command, correction included, N.
    pub effort: V,
    /// The observed energy `L(n)` before this tick's correction, J.
    pub observed_energy: V::Scalar,
    /// The damping `α` injected on this tick, N·s/m; 0 from a stabilizer that corrects in another way.
    #[doc(alias = "damping")]
    pub alpha: V::Scalar,
    /// The part of the debt that this tick's correction cannot serve, J; it stays in `L`.
    pub shortfall: V::Scalar,
    /// Whether the sample was accepted, lane by lane; if not, the effort is 0, or what a watchdog or a guard gives instead.
    pub accepted: <V::Scalar as Scalar>::Mask,
}

/// The correction before the first tick: no effort, nothing corrected, accepted.
impl<V: Signal> Default for Correction<V> {
    fn default() -> Self {
        Self::none(V::zero())
    }
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
        same_lanes::<V::Scalar>(self.accepted, other.accepted)
    }

    /// The correction of a port without a stabilizer: `effort` unchanged, and nothing else.
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

    /// This correction where its effort is finite; elsewhere a zero effort without damping, not accepted, and the whole debt a
    /// shortfall.
    #[inline(always)]
    #[must_use]
    pub fn checked(self) -> Self {
        let finite = self.effort.finite();
        let debt = self.shortfall.larger(-self.observed_energy);
        Self {
            effort: V::choose(finite, self.effort, V::zero()),
            alpha: V::Scalar::choose(finite, self.alpha, V::Scalar::of(0.0)),
            shortfall: V::Scalar::choose(finite, self.shortfall, debt),
            accepted: self.accepted & finite,
            ..self
        }
    }
}
