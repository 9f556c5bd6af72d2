//! The account of one side of a link.

use lyapunov_core::{
    LyapunovCandidate, ParameterError, PortSample, Requirement, Scalar, Signal, Snapshot, exact_sum,
};

/// Energy that the other side reported as absorbed, less what the channel gave, plus what the correction dissipated:
/// the candidate of a [`TwoPortSide`](super::TwoPortSide).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct OneWay<V: Signal> {
    received: V::Scalar,
    booked: V::Scalar,
    absorbed: V::Scalar,
    asked: V,
}

impl<V: Signal> OneWay<V> {
    pub(super) fn new() -> Self {
        let zero = V::Scalar::of(0.0);
        Self { received: zero, booked: zero, absorbed: zero, asked: V::zero() }
    }

    /// A sum that is not larger than the one before is an old message, or a spoilt one.
    #[inline]
    pub(super) fn receive(&mut self, energy: V::Scalar) {
        let newer = energy.above(self.received) & energy.finite();
        self.received = V::Scalar::choose(newer, energy, self.received);
    }

    #[inline]
    pub(super) fn absorbed(&self) -> V::Scalar {
        self.absorbed
    }

    /// The effort of the channel, before it is corrected.
    #[inline]
    pub(super) fn ask(&mut self, effort: V) {
        self.asked = effort;
    }
}

impl<V: Signal> LyapunovCandidate<V> for OneWay<V> {
    #[inline]
    fn decrease(&mut self, sample: &PortSample<V>) -> V::Scalar {
        let zero = V::Scalar::of(0.0);
        let work = sample.work.sum();
        let crossed = self.asked.inner(sample.displacement);
        let burnt = work - crossed;
        // What is not a number is left out, and what was received must not be lost with it.
        let sound = burnt.finite();
        let came = crossed.larger(zero);
        // What the total rounds off stays with this side, to the bit: told or kept, and never both.
        let (total, kept) = exact_sum(self.absorbed, came);
        let told = sound & kept.finite();
        self.absorbed = V::Scalar::choose(told, total, self.absorbed);
        let kept = V::Scalar::choose(told, kept, zero);
        let credit = self.received - self.booked;
        self.booked = V::Scalar::choose(sound, self.received, self.booked);
        V::Scalar::choose(sound, credit + (crossed.smaller(zero) + burnt) + kept, burnt)
    }
}

impl<V: Signal> Snapshot for OneWay<V> {
    type State = (V::Scalar, V::Scalar, V::Scalar, V);

    fn state(&self) -> Self::State {
        (self.received, self.booked, self.absorbed, self.asked)
    }

    fn restored(
        self,
        (received, booked, absorbed, asked): Self::State,
    ) -> Result<Self, ParameterError> {
        for energy in [received, booked, absorbed] {
            Requirement::NonNegative.check("stored exchange", energy)?;
        }
        // The effort may be anything: one that is not finite spoils its own tick only.
        Ok(Self { received, booked, absorbed, asked })
    }
}
