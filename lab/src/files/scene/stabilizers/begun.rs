//! Candidate that begins at the first sample.

use lyapunov::{LyapunovCandidate, Mask, PortSample, Scalar, Signal};

/// A candidate counted from the first sample that it sees, whose decrease is 0.
///
/// The measured start need not be the scene's: an encoder rounds it, a difference begins at rest, and a log begins where
/// it was cut.
#[derive(Clone, Copy, Debug)]
pub(super) struct Begun<C, T: Scalar> {
    candidate: C,
    has_begun: T::Mask,
}

impl<C, T: Scalar> Begun<C, T> {
    /// The `candidate`, whatever state it starts from itself.
    pub(super) fn new(candidate: C) -> Self {
        Self { candidate, has_begun: Mask::of(false) }
    }
}

impl<V: Signal, C: LyapunovCandidate<V>> LyapunovCandidate<V> for Begun<C, V::Scalar> {
    #[inline(always)]
    fn decrease(&mut self, sample: &PortSample<V>) -> V::Scalar {
        let decrease = self.candidate.decrease(sample);
        // Zero times what is not finite is NaN, which is rejected: then the next sample is the first.
        let nothing = decrease * V::Scalar::of(0.0);
        let counted = V::Scalar::choose(self.has_begun, decrease, nothing);
        self.has_begun = self.has_begun | decrease.finite();
        counted
    }
}

#[cfg(test)]
mod tests {
    use lyapunov::{HeldTick, StorageFunction};

    use super::*;

    #[test]
    fn the_first_finite_sample_is_the_start() {
        // ½ · 2 N/m · x², from 3 m on: 9 J there, 4 J at 2 m.
        let stored = StorageFunction::starting(|x: f64, _| x * x, 0.5, 0.0);
        let mut begun = Begun::new(stored);
        let at = |position| {
            let still =
                HeldTick { period: 1.0, position, velocity: 0.0, displacement: 0.0, applied: 0.0 };
            still.sample()
        };
        assert!(begun.decrease(&at(f64::NAN)).is_nan());
        assert_eq!([3.0, 2.0, 3.0].map(|x| begun.decrease(&at(x))), [0.0, 5.0, -5.0]);
    }
}
