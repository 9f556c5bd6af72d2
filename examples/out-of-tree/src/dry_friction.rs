//! An own candidate.

use lyapunov::{ParameterError, Requirement, prelude::*};

/// The port's energy, credited with what dry friction on every axis must have dissipated: `−ΔV = Σ fᵢ Δxᵢ + F |Δxᵢ|`.
#[derive(Clone, Copy, Debug)]
pub struct DryFriction<T> {
    force: T,
}

impl<T: Scalar> DryFriction<T> {
    /// The credit of a friction of `force` N.
    pub fn of(force: T) -> Result<Self, ParameterError> {
        Ok(Self { force: Requirement::NonNegative.check("friction", force)? })
    }
}

impl<V: Signal> LyapunovCandidate<V> for DryFriction<V::Scalar> {
    fn decrease(&mut self, sample: &PortSample<V>) -> V::Scalar {
        let credit = self.force * sample.displacement.map(Scalar::magnitude).sum();
        sample.work.sum() + V::Scalar::choose(credit.finite(), credit, V::Scalar::of(0.0))
    }
}

impl<T: Scalar> Snapshot for DryFriction<T> {
    type State = ();

    fn state(&self) {}

    fn restored(self, _state: ()) -> Result<Self, ParameterError> {
        Ok(self)
    }
}
