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
    use lyapunov::lanes::AutoF64x8;
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

    /// Every other lane misses the first sample, and begins with the second.
    #[test]
    fn each_lane_begins_at_a_first_sample_of_its_own() {
        type Lanes = AutoF64x8;
        let zero = Lanes::of(0.0);
        let stored = StorageFunction::starting(|x: Lanes, _| x * x, zero, zero);
        let mut begun = Begun::new(stored);
        let mut decrease = |first: f64, second: f64| {
            let position = Lanes::from_lanes(|lane| [first, second][lane % 2]);
            let (period, velocity, displacement) = (Lanes::of(1.0), zero, zero);
            let still = HeldTick { period, position, velocity, displacement, applied: zero };
            let decrease: Lanes = begun.decrease(&still.sample());
            [0, 1, 6, 7].map(|lane| decrease.lane(lane))
        };
        let [even, odd, ..] = decrease(3.0, f64::NAN);
        assert!(even == 0.0 && odd.is_nan());
        assert_eq!(decrease(2.0, 5.0), [5.0, 0.0, 5.0, 0.0]);
        assert_eq!(decrease(3.0, 4.0), [-5.0, 9.0, -5.0, 9.0]);
    }
}
