//! The watchdog: the tests of `tests/readings`, and what is told while it holds.

#[expect(dead_code, reason = "the dice are for the other tests of readings")]
#[path = "../readings/support.rs"]
mod support;
#[path = "../readings/watchdog.rs"]
mod watchdog;

use lyapunov::{
    PortSample, Snapshot, Stabilizer,
    stabilizers::{StabilizerExt, WatchdogTimes},
};

use crate::support::{PERIOD, popc};

/// A rejected tick tells no damping, and as shortfall the debt and nothing of a credit.
#[test]
fn what_is_owed_is_told_while_it_holds() {
    for (energy, debt) in [(-3.0, 3.0), (3.0, 0.0)] {
        let times = WatchdogTimes { hold: 1.0, rise: 0.0 };
        let mut dog = popc::<f64>().watched::<f64>(times).expect("times");
        let rest = PortSample::starting(PERIOD, 0.0, 0.0);
        dog.stabilize(&PortSample { work: energy, ..rest }, 5.0);
        let held = dog.stabilize(&PortSample { position: f64::NAN, velocity: 1.0, ..rest }, 7.0);
        assert_eq!((held.accepted, held.effort, held.alpha), (false, 5.0, 0.0));
        assert_eq!((held.observed_energy, held.shortfall), (energy, debt));
    }
}

/// Stored on any tick of a rise, of a hold and of what comes after, it goes on as the one that was not.
#[test]
fn a_stored_watchdog_goes_on() {
    let times = WatchdogTimes { hold: 2.5 * PERIOD, rise: 4.0 * PERIOD };
    let fresh = popc::<f64>().watched::<f64>(times).expect("times");
    let tick = |came: bool| {
        let position = if came { 0.0 } else { f64::NAN };
        PortSample { position, ..PortSample::starting(PERIOD, position, 0.0) }
    };
    let came = [1, 1, 0, 1, 1, 1, 0, 0, 1, 0, 0, 0, 0, 1, 1, 1].map(|it| it == 1);
    let mut running = fresh;
    let mut told = Vec::new();
    let mut states = Vec::new();
    for came in came {
        states.push(running.state());
        told.push(running.stabilize(&tick(came), 8.0));
    }
    // It rose, held, and let go.
    assert!([2.0, 4.0, 8.0, 0.0].iter().all(|force| told.iter().any(|it| it.effort == *force)));
    for (cut, state) in states.into_iter().enumerate() {
        let mut resumed = fresh.restored(state).expect("a memory");
        for (came, told) in came.iter().zip(&told).skip(cut) {
            assert_eq!(resumed.stabilize(&tick(*came), 8.0), *told, "stored before tick {cut}");
        }
    }
}
