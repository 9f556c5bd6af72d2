//! Damper of an ideal environment: the energy that it dissipates.

use lyapunov_core::{
    LyapunovCandidate, ParameterError, PortSample, Requirement, Scalar, Signal, Snapshot,
};

/// A term of a reference: `−ΔV = −b |Δp|² / T`, what a damper `b` (N·s/m) on the deformation `p(x)` (m) dissipates at
/// least over a tick, J.
///
/// Whatever the motion within the tick, `b ∫ |ṗ|² dt ≥ b |Δp|² / T`, so that the reference asks for no more than an
/// ideal environment takes. Of a wall `p` is the depth, 0 outside. A work or a deformation that is not finite is passed over, and
/// so is one that the term has no room for. The first finite deformation, where the one at the start is not, dissipates nothing.
#[derive(Clone, Copy, Debug)]
pub struct ReferenceDamper<F, V: Signal> {
    damping: V::Scalar,
    deformation: F,
    last: V,
}

/// `deformation` in the lanes of the mask, and NaN elsewhere.
#[inline]
fn known<V: Signal>(mask: <V::Scalar as Scalar>::Mask, deformation: V) -> V {
    V::choose(mask, deformation, V::splat(V::Scalar::of(f64::NAN)))
}

impl<F: Fn(V) -> V, V: Signal> ReferenceDamper<F, V> {
    /// The `damping` of a `deformation`, seen from the position the loop starts in.
    ///
    /// # Errors
    /// `damping` below 0, infinite or NaN.
    pub fn starting(
        damping: V::Scalar,
        deformation: F,
        position: V,
    ) -> Result<Self, ParameterError> {
        let damping = Requirement::NonNegative.check("reference damping", damping)?;
        let last = deformation(position);
        let last = known(position.finite() & last.finite(), last);
        Ok(Self { damping, last, deformation })
    }
}

impl<V: Signal, F: Fn(V) -> V> LyapunovCandidate<V> for ReferenceDamper<F, V> {
    #[inline]
    fn decrease(&mut self, sample: &PortSample<V>) -> V::Scalar {
        let now = known(sample.work.finite(), (self.deformation)(sample.position));
        let deformed = now - self.last;
        self.last = V::choose(now.finite(), now, self.last);
        let burnt = self.damping * (deformed.inner(deformed) / sample.period);
        V::Scalar::choose(burnt.finite(), -burnt, V::Scalar::of(0.0))
    }
}

impl<F, V: Signal> Snapshot for ReferenceDamper<F, V> {
    /// The last deformation, m.
    type State = V;

    fn state(&self) -> V {
        self.last
    }

    fn restored(self, last: V) -> Result<Self, ParameterError> {
        Ok(Self { last: Requirement::Finite.check_known("stored deformation", last)?, ..self })
    }
}
