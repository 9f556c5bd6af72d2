//! Responses of every stabilizer to unsound samples.

use lyapunov::laws::Samples;
use lyapunov::{Correction, Mask, PortSample, Scalar, Signal, Stabilizer};

use crate::support::PERIOD;

fn finite<V: Signal>(correction: &Correction<V>) -> bool {
    correction.effort.finite().all()
        && (correction.observed_energy + correction.alpha + correction.shortfall).finite().all()
        && !correction.alpha.below(V::Scalar::of(0.0)).any()
        && !correction.shortfall.below(V::Scalar::of(0.0)).any()
}

/// Sound samples give finite numbers, alike in two copies; a bad effort is told as rejected, and no bad field is remembered.
pub(crate) fn is_answered<V: Signal>(stabilizer: &(impl Stabilizer<V> + Clone)) {
    let (mut one, mut other) = (stabilizer.clone(), stabilizer.clone());
    for (sample, effort) in Samples::<V>::new(V::Scalar::of(PERIOD)).seeded(4) {
        let (correction, again) =
            (one.stabilize(&sample, effort), other.stabilize(&sample, effort));
        assert!(
            finite(&correction) && correction.accepted.all(),
            "{sample:?} {effort:?} {correction:?}"
        );
        assert_eq!(format!("{correction:?}"), format!("{again:?}"));
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY].map(V::Scalar::of) {
            let spoilt = V::splat(bad);
            let mut rejecting = one.clone();
            let rejected = rejecting.stabilize(&sample, spoilt);
            assert!(rejected.effort.finite().all() && !rejected.accepted.any(), "{rejected:?}");
            assert!(finite(&rejecting.stabilize(&sample, effort)));
            for flawed in [
                PortSample { period: bad, ..sample },
                PortSample { position: spoilt, ..sample },
                PortSample { velocity: spoilt, ..sample },
                PortSample { displacement: spoilt, ..sample },
                PortSample { applied: spoilt, ..sample },
                PortSample { work: spoilt, ..sample },
            ] {
                let mut spoilt = one.clone();
                assert!(spoilt.stabilize(&flawed, effort).effort.finite().all(), "{flawed:?}");
                let next = spoilt.stabilize(&sample, effort);
                assert!(finite(&next) && next.accepted.all(), "after {flawed:?}: {next:?}");
            }
        }
    }
}
