//! Shortfall of shaped corrections: the part that is held back.

use approx::assert_relative_eq;
use lyapunov::{
    DampingLimit, Popc, PortEnergy, PortSample, Snapshot, Stabilizer, stabilizers::StabilizerExt,
};

use crate::support::{Dice, PERIOD, popc};

/// Shortfalls after a debt of 40 µJ at 0.1 m/s, in µJ, while the ledger is told of no work: each tick owes what it owed.
fn held_back(mut member: impl Stabilizer<f64>) -> Vec<f64> {
    let mut told = Vec::new();
    for work in [-4e-5, 0.0, 0.0, 0.0] {
        let moving = PortSample { work, ..PortSample::starting(PERIOD, 0.0, 0.1) };
        let correction = member.stabilize(&moving, 3.0);
        assert!(correction.accepted && correction.alpha > 0.0, "{correction:?}");
        told.push(1e6 * correction.shortfall);
    }
    told
}

/// Of an eighth seven eighths are left; with 100 N/s a tick more gives 10 µJ more; a rise over four ticks gives quarters.
#[test]
fn what_is_not_served_yet_is_told() {
    let spread = popc().spread_over(8).expect("ticks");
    let limited = popc().rate_limited(100.0).expect("a rate");
    let rising = popc().rising_over(4).expect("ticks");
    for (found, expected) in [
        (held_back(spread), [35.0, 35.0, 35.0, 35.0]),
        (held_back(limited), [30.0, 20.0, 10.0, 0.0]),
        (held_back(rising), [30.0, 20.0, 10.0, 0.0]),
    ] {
        for (found, expected) in found.into_iter().zip(expected) {
            assert_relative_eq!(found, expected, epsilon = 1e-9);
        }
    }
}

/// A correction of the largest number beside an effort of minus half of it and a little rounds so that the force given, less
/// the effort asked, is infinite. What is remembered of it is a number, so that it can be stored.
#[test]
fn a_correction_at_the_end_of_the_range_is_remembered() {
    let limit = DampingLimit::at(f64::INFINITY).expect("a limit");
    let mut limited = Popc::new(PortEnergy, limit).rate_limited(f64::INFINITY).expect("a rate");
    let asked = -(2f64.powi(52) + 3.0) * 2f64.powi(970);
    let owes = PortSample { work: -f64::MAX / 4.0, ..PortSample::starting(0.25, 0.0, 1.0) };
    let told = limited.stabilize(&owes, asked);
    assert!(told.accepted && told.alpha == f64::MAX && (told.effort - asked).is_infinite());
    assert!(limited.restored(limited.state()).is_ok(), "{limited:?}");
}

/// A rejected tick gets no force, though at this speed no share of a correction is let through.
#[test]
fn a_rejected_tick_gets_no_force() {
    let mut slow = popc().above_velocity(1.0).expect("a speed");
    let owes = PortSample { work: -4e-5, ..PortSample::starting(PERIOD, 0.0, 0.1) };
    let told = slow.stabilize(&PortSample { period: 0.0, ..owes }, 3.0);
    assert_eq!((told.accepted, told.effort, told.alpha), (false, 0.0, 0.0));
    assert_eq!((told.observed_energy, told.shortfall), (-4e-5, 4e-5));
}

/// A correction that is let through whole keeps its bits, whatever the numbers.
#[test]
fn a_whole_share_changes_no_bit() {
    let (mut plain, mut dice) = (popc(), Dice::of(9));
    let mut whole = popc().above_velocity(0.0).expect("a speed");
    for _ in 0..500 {
        let [work, velocity, effort] = [1e-4, 0.3, 5.0].map(|size| dice.within(size));
        let sample = PortSample { work, ..PortSample::starting(PERIOD, 0.0, velocity) };
        assert_eq!(whole.stabilize(&sample, effort), plain.stabilize(&sample, effort));
    }
}
