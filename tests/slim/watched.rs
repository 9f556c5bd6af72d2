//! The watchdog: the tests of `tests/readings`, and what is told while it holds.

#[expect(dead_code, reason = "the dice are for the other tests of readings")]
#[path = "../readings/support.rs"]
mod support;
#[path = "../readings/watchdog.rs"]
mod watchdog;

use lyapunov::{
    PortSample, Stabilizer,
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
