//! Sums that have no room for more, against whole numbers: at a bound, and at the end of the scalar's range.

use lyapunov::{
    DampingLimit, PortSample, Snapshot, Stabilizer,
    candidates::InContact,
    stabilizers::{Account, LimitCredit, Sharing, StabilizerExt, TwoLayer, TwoPortSide},
};

use crate::support::{Dice, PERIOD, popc};

/// In sixteenths of what is too large: what there is room for is booked, and nothing else is.
#[test]
fn what_there_is_room_for_is_booked() {
    let unit = 2f64.powi(1020);
    let mut end = TwoLayer::slave(Sharing { start: 0.0, share: 0.0 }).expect("an end");
    let (mut dice, mut exact, mut refused) = (Dice::of(6), 0i64, 0);
    for tick in 0..2000 {
        let change = dice.within(15.0).round();
        let fits = (exact + change as i64).abs() < 16;
        exact += if fits { change as i64 } else { 0 };
        refused += i32::from(!fits);
        let rest = PortSample { work: change * unit, ..PortSample::starting(PERIOD, 0.0, 0.0) };
        let told = end.stabilize(&rest, 0.0);
        let found = (told.observed_energy / unit, told.accepted, told.shortfall / unit);
        // What is below 0 is told.
        let lacks = (-exact).max(0) as f64;
        assert_eq!(found, (exact as f64, fits, lacks), "{change} on tick {tick}");
    }
    assert!(refused > 200, "{refused} only");
}

fn limit_through_a_reference(mut end: impl LimitCredit<f64>, most: f64) {
    end.limit_credit(most);
}

fn forfeits(mut end: impl Account<f64> + LimitCredit<f64>) {
    end.grant(5.0).expect("a credit");
    for (most, held) in [(6.0, 5.0), (2.0, 2.0), (3.0, 2.0)] {
        limit_through_a_reference(&mut end, most);
        assert_eq!(end.observed_energy(), held, "at most {most}");
    }
    end.owe(4.0).expect("a debt");
    end.limit_credit(1.0);
    assert_eq!(end.observed_energy(), -2.0, "a debt stays");
}

#[test]
fn credit_above_a_bound_is_forfeited() {
    forfeits(TwoLayer::slave(Sharing { start: 0.0, share: 0.1 }).expect("an end"));
    forfeits(TwoPortSide::<f64>::new(DampingLimit::at(8.0).expect("a limit")));
    forfeits(popc::<f64>().bounded(1e9).expect("a bound"));
    forfeits(popc::<f64>().reset_at(InContact { position: 0.0 }));
}

/// The sum for the other side has no work of a spoilt tick, and does not leave the range.
#[test]
fn what_is_spoilt_or_has_no_room_is_not_told() {
    let mut side = TwoPortSide::<f64>::new(DampingLimit::at(8.0).expect("a limit"));
    let unit = 2f64.powi(1023);
    let mut absorbs = |asked: f64, displacement: f64, work: f64| {
        let rest = PortSample::starting(PERIOD, 0.0, 0.0);
        // Asked now, and done until the next tick; then nothing is asked.
        side.stabilize(&rest, asked);
        side.stabilize(&PortSample { displacement, work, ..rest }, 0.0);
        side.absorbed()
    };
    assert_eq!(absorbs(2.0, 3.0, 6.0), 6.0);
    for work in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(absorbs(2.0, 3.0, work), 6.0);
    }
    assert_eq!(absorbs(2.0, f64::NAN, 6.0), 6.0);
    // The first fits, as 6 J are no digit of it, and the sum with a second one is infinite.
    assert_eq!(absorbs(unit, 1.0, unit), unit);
    assert_eq!(absorbs(unit, 1.0, unit), unit);
}

/// A contact that was stored goes on: its credit is not forfeited as that of another contact would be.
#[test]
fn a_stored_contact_keeps_its_credit() {
    let fresh = popc::<f64>().reset_at(InContact { position: 0.0 });
    let inside = |work: f64| PortSample { work, ..PortSample::starting(PERIOD, 1.0, 0.0) };
    let mut running = fresh;
    assert_eq!(running.stabilize(&inside(5.0), 0.0).observed_energy, 5.0);
    let mut resumed = fresh.restored(running.state()).expect("a memory");
    assert_eq!(resumed.stabilize(&inside(1.0), 0.0).observed_energy, 6.0);
    // One that begins forfeits what there is.
    let (account, _) = running.state();
    let mut begins = fresh.restored((account, 0.0)).expect("a memory");
    assert_eq!(begins.stabilize(&inside(1.0), 0.0).observed_energy, 1.0);
}
