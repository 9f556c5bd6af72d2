//! Cases that the targets found, and that were mended.

use lyapunov_core::{Correction, PortSample, Stabilizer};
use lyapunov_stabilizers::{Sharing, TwoLayer};

/// Damping of `gain` times a debt overflowed; an infinite damping of no velocity is NaN, so that rest was rejected for good.
#[test]
fn a_two_layer_end_accepts_rest_after_any_debt() {
    let sharing = Sharing { start: 0.0, share: 0.0 };
    let mut master = TwoLayer::master(sharing, 1.0, 1e100_f64).expect("an end");
    let still = PortSample::starting(1e-3, 0.0, 0.0);
    let gave = PortSample { work: -1e300, ..still };
    for sample in [gave, still] {
        let told: Correction<f64> = master.stabilize(&sample, 2.0);
        assert!(told.accepted && told.effort == 0.0 && told.alpha.is_finite(), "{told:?}");
    }
}

/// The sum of the packets overflowed, and left the tank at minus infinity.
#[test]
fn a_two_layer_end_sends_no_infinity() {
    let sharing = Sharing { start: 1e308, share: 1.0 };
    let mut master = TwoLayer::master(sharing, 0.0, 0.0_f64).expect("an end");
    for _ in 0..5 {
        master.receive(master.sent());
        let sample = PortSample::starting(1e-3, 0.0, 0.1);
        let told: Correction<f64> = master.stabilize(&sample, 2.0);
        assert!(told.observed_energy.is_finite() && master.sent().is_finite(), "{told:?}");
    }
}
