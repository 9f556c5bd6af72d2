//! Drift compensation: what a port answers, and ticks that are spoilt.

use approx::assert_relative_eq;
use lyapunov::{
    AdmittanceSample, Correction, DampingLimit, PortSample, Sampled, Snapshot, Stabilizer,
    stabilizers::{Account, DriftCompensated, TwoPortSide},
};

use crate::support::PERIOD;

type Port = DriftCompensated<TwoPortSide<f64, Sampled>, f64>;

/// A port that lags by 0.1 mm: 0.1 m/s against 1 N, not paid, is taken off.
fn lagging() -> Port {
    let side = TwoPortSide::new(DampingLimit::at(f64::INFINITY).expect("none")).sampled();
    let mut port = DriftCompensated::new(side, f64::INFINITY).expect("no limit");
    port.stabilize(&load(-1.0), 0.1);
    assert_relative_eq!(port.drift(), -1e-4, max_relative = 1e-12);
    port
}

fn load(force: f64) -> PortSample<f64> {
    AdmittanceSample::starting(PERIOD, force).into()
}

/// Against 4 N that answer by 30 N·s/m: 0.1 m/s more takes 0.4 + 0.3 mJ at rest, and 0.4 + 0.9 mJ on top of 0.2 m/s. Half of
/// it is there, so half of it comes back.
#[test]
fn what_the_port_answers_is_paid() {
    for (asked, paid, costs) in [(0.0, 0.0, 7e-4), (0.2, 8e-4, 13e-4)] {
        let mut changed = lagging();
        changed.set_impedance(30.0).expect("an impedance");
        for mut port in [lagging().meeting(30.0).expect("an impedance"), changed] {
            assert_eq!(port.impedance(), 30.0);
            port.receive(paid + costs / 2.0);
            let told: Correction<f64> = port.stabilize(&load(-4.0), asked);
            assert_relative_eq!(told.effort, asked + 0.05, max_relative = 1e-12);
        }
    }
}

/// A spoilt tick moves nothing, spends nothing and is no drift, though there is plenty to spend.
#[test]
fn a_spoilt_tick_is_no_drift() {
    for (sample, asked) in [
        (load(-1.0), f64::NAN),
        (load(f64::NAN), 0.3),
        (PortSample { period: 0.0, ..load(-1.0) }, 0.3),
    ] {
        let mut port = lagging();
        port.receive(1.0);
        // A tenth of it comes back.
        port.set_speed(0.01).expect("a speed");
        port.stabilize(&load(-1.0), 0.0);
        let (drift, energy) = (port.drift(), port.observed_energy());
        assert!(drift < -8e-5 && energy > 0.9, "{port:?}");
        let told = port.stabilize(&sample, asked);
        assert_eq!((told.accepted, told.effort), (false, 0.0), "{told:?}");
        assert_eq!((port.drift(), port.observed_energy()), (drift, energy), "{sample:?}");
    }
}

/// A drift that is absurd is taken back, and the energy that this absorbs, beyond the range, is left out.
#[test]
fn no_infinity_is_booked() {
    let port = lagging();
    let (account, _) = port.state();
    let mut port = port.restored((account, 1e197)).expect("a memory");
    assert_eq!(port.drift(), 1e197);
    let told = port.stabilize(&load(-1e150), 0.0);
    assert!(told.accepted && told.effort < -1e199, "{told:?}");
    assert!(port.observed_energy().is_finite() && port.drift().abs() < 1e185, "{port:?}");
}
