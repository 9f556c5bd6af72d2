//! Sums that have no room for more, against whole numbers: at a bound, and at the end of the scalar's range.

use lyapunov::{
    DampingLimit, PortSample, Stabilizer,
    stabilizers::{Account, LimitCredit, Sharing, TwoLayer, TwoPortSide},
};

use crate::support::{Dice, PERIOD};

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
        let found = (told.observed_energy / unit, told.accepted);
        assert_eq!(found, (exact as f64, fits), "{change} on tick {tick}");
    }
    assert!(refused > 200, "{refused} only");
}

fn forfeits(mut end: impl Account<f64> + LimitCredit<f64>) {
    end.grant(5.0).expect("a credit");
    for (most, held) in [(6.0, 5.0), (2.0, 2.0), (3.0, 2.0)] {
        end.limit_credit(most);
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
}
