//! Messages that come late, twice, spoilt or never, against a plain sum of the packets up to the newest that came.

use lyapunov::{
    DampingLimit, PortSample, Snapshot, Stabilizer,
    stabilizers::{Sharing, TwoLayer, TwoPortSide},
};

use crate::support::{Dice, PERIOD};

/// What comes on each tick, and the packets up to the newest that has come by then: whole numbers of 2⁻¹⁰ J, so that
/// every sum of them is exact.
fn messages(seed: u64) -> Vec<(f64, f64)> {
    let mut dice = Dice::of(seed);
    let packets: Vec<f64> = (0..400).map(|_| dice.within(64.0).abs().round() / 1024.0).collect();
    let sum = |count: usize| packets[..count].iter().sum::<f64>();
    let mut newest = 0;
    let mut message = |tick: usize| {
        if let Some(spoilt) = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1.0].get(tick % 50) {
            return (*spoilt, sum(newest));
        }
        let late = dice.within(12.0).abs() as usize;
        let come = (tick + 1).saturating_sub(late);
        newest = newest.max(come);
        (sum(come), sum(newest))
    };
    (0..400).map(&mut message).collect()
}

/// An end that neither moves nor sends holds what came, each packet once.
fn holds_what_came<S: Stabilizer<f64> + Clone>(end: &S, receive: impl Fn(&mut S, f64)) {
    let rest = PortSample::starting(PERIOD, 0.0, 0.0);
    for seed in 1..20 {
        let mut end = end.clone();
        for (tick, (told, came)) in messages(seed).into_iter().enumerate() {
            receive(&mut end, told);
            let held = end.stabilize(&rest, 0.0).observed_energy;
            assert_eq!(held, came, "tick {tick} of {seed}, told {told} J");
        }
    }
}

#[test]
fn an_old_message_takes_nothing_back_and_brings_nothing_twice() {
    let side = TwoPortSide::<f64>::new(DampingLimit::at(8.0).expect("a limit"));
    holds_what_came(&side, |side, told| side.receive(told));
    holds_what_came(&side.sampled(), |side, told| side.receive(told));
    let end = TwoLayer::slave(Sharing { start: 0.0, share: 0.0 }).expect("an end");
    holds_what_came(&end, |end, told| end.receive(told));
}

/// A restored end knows what has come and what of it is booked: of a sum that was told before it takes the rest.
fn remembers_what_came<S: Stabilizer<f64> + Snapshot + Clone>(
    fresh: &S,
    receive: impl Fn(&mut S, f64),
) {
    let rest = PortSample::starting(PERIOD, 0.0, 0.0);
    let (mut booked, mut waiting) = (fresh.clone(), fresh.clone());
    receive(&mut booked, 5.0);
    receive(&mut waiting, 5.0);
    booked.stabilize(&rest, 0.0);
    for (end, held) in [(booked, 5.0), (waiting, 5.0)] {
        let mut again = fresh.clone().restored(end.state()).expect("a memory");
        receive(&mut again, 3.0);
        assert_eq!(again.stabilize(&rest, 0.0).observed_energy, held, "an old message");
        receive(&mut again, 7.0);
        assert_eq!(again.stabilize(&rest, 0.0).observed_energy, held + 2.0);
    }
}

#[test]
fn a_restored_end_counts_nothing_twice() {
    let side = TwoPortSide::<f64>::new(DampingLimit::at(8.0).expect("a limit"));
    remembers_what_came(&side, |side, told| side.receive(told));
    let end = TwoLayer::slave(Sharing { start: 0.0, share: 0.0 }).expect("an end");
    remembers_what_came(&end, |end, told| end.receive(told));
}
