//! Cases that the targets found, and that were mended.

use lyapunov_core::{Compensated, Correction, PortEnergy, PortSample, Stabilizer};
use lyapunov_stabilizers::{Account, DampingLimit, Popc, Sharing, TwoLayer};

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

/// Half of a last place that a full sum had gathered carried it beyond the range: the account was NaN for good.
#[test]
fn a_compensated_account_has_no_room_beyond_the_largest_number() {
    let popc = Popc::<f64>::new(PortEnergy, DampingLimit::at(8.0).expect("a limit"));
    let mut full = popc.summed_in::<Compensated<f64>>();
    let quarter = 2f64.powi(969);
    let rest = PortSample::starting(1e-3, 0.0, 0.0);
    for (work, room) in [(f64::MAX, true), (quarter, true), (quarter, false), (0.0, true)] {
        let told: Correction<f64> = full.stabilize(&PortSample { work, ..rest }, 0.0);
        assert_eq!((told.accepted, told.observed_energy), (room, f64::MAX), "{work:e} J");
    }
    assert!(full.grant(quarter).is_err() && full.owe(f64::MAX).is_ok(), "{full:?}");
    assert_eq!(full.observed_energy(), quarter);
}
