//! Observed energy of one side of a two-port.

use lyapunov_core::{LyapunovCandidate, PortSample, Scalar, Signal};

/// Candidate of a [`TwoPortSide`](super::TwoPortSide): the energy that the other side reports as absorbed, less the
/// energy that this side gave.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct OneWay<T> {
    received: T,
    booked: T,
    absorbed: T,
}

impl<T: Scalar> OneWay<T> {
    pub(super) fn new() -> Self {
        let zero = T::of(0.0);
        Self { received: zero, booked: zero, absorbed: zero }
    }

    /// A sum that is not larger than the one before is an old message, or a spoilt one.
    #[inline]
    pub(super) fn receive(&mut self, energy: T) {
        let newer = energy.above(self.received) & energy.finite();
        self.received = T::choose(newer, energy, self.received);
    }

    #[inline]
    pub(super) fn absorbed(&self) -> T {
        self.absorbed
    }
}

impl<V: Signal> LyapunovCandidate<V> for OneWay<V::Scalar> {
    #[inline]
    fn decrease(&mut self, sample: &PortSample<V>) -> V::Scalar {
        let zero = V::Scalar::of(0.0);
        let work = sample.work.sum();
        let total = self.absorbed + work.larger(zero);
        self.absorbed = V::Scalar::choose(total.finite(), total, self.absorbed);
        let credit = self.received - self.booked;
        let decrease = credit + work.smaller(zero);
        // A work that is not a number is left out, and what was received must not be lost with it.
        let sound = work.finite();
        self.booked = V::Scalar::choose(sound, self.received, self.booked);
        V::Scalar::choose(sound, decrease, work)
    }
}
