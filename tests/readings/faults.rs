//! Faults that readings notice or put right, at every tick of a loop: the force of the watchdog meanwhile and afterwards, and
//! the count of the ledger.

use approx::assert_relative_eq;

use lyapunov::{
    DampingLimit, Popc, PortEnergy, Reading, Readings, Stabilizer,
    stabilizers::{StabilizerExt, WatchdogTimes},
};

use super::support::PERIOD;

const TICKS: usize = 200;

/// Ticks for which a force is held.
const HOLD: usize = 5;

/// Ticks in which it rises again.
const RISE: usize = 10;

/// A fault that lasts for some ticks.
#[derive(Clone, Copy, Debug)]
enum Fault {
    Position(f64),
    Missed,
    Clock(f64),
}

/// A mass and a hand that press into a wall of 6 kN/m, and what really crossed the port.
struct Loop {
    position: f64,
    velocity: f64,
    absorbed: f64,
}

impl Loop {
    fn moves(&mut self, force: f64) {
        let hand = 300.0 * (self.position - 2e-3) + self.velocity;
        self.velocity -= (hand + force) * PERIOD / 0.2;
        let way = self.velocity * PERIOD;
        self.position += way;
        self.absorbed += force * way;
    }
}

fn check(fault: Fault, at: usize, length: usize) {
    let readings = Readings::every(PERIOD).and_then(|it| it.no_faster_than(5.0));
    let mut readings = readings.expect("readings").clocked();
    let limit = DampingLimit::of_mass(0.5, 0.2, PERIOD).expect("a limit");
    let [hold, rise] = [HOLD, RISE].map(|ticks| ticks as f64 * PERIOD);
    // Half a period more, so that the last tick of the hold does not hang on a rounding.
    let times = WatchdogTimes { hold: hold + 0.5 * PERIOD, rise };
    let mut popc = Popc::new(PortEnergy, limit).watched(times).expect("times");
    let mut port = Loop { position: -2e-3, velocity: 0.2, absorbed: 0.0 };
    let (mut applied, mut silent, mut risen) = (0.0, 0, 0);
    for tick in 0..TICKS {
        let (mut position, mut time) = (port.position, PERIOD * tick as f64);
        let is_faulty = (at..at + length).contains(&tick);
        match fault {
            Fault::Position(number) if is_faulty => position = number,
            Fault::Clock(now) if is_faulty => time = now,
            _ => {}
        }
        let checked = match fault {
            Fault::Missed if is_faulty => readings.missed_at(time, applied),
            _ => readings.read_at(time, Reading { position, applied }),
        };
        let sample = checked.sample;
        let asked = if sample.position > 0.0 { 6000.0 * sample.position } else { 0.0 };
        let told = popc.stabilize(&sample, asked);
        let place = || format!("{fault:?} at tick {at} for {length}, tick {tick}: {told:?}");
        // A wrong clock counts one period.
        let is_noticed = is_faulty && !matches!(fault, Fault::Clock(_));
        assert_eq!((checked.accepted, told.accepted), (!is_noticed, !is_noticed), "{}", place());
        if told.accepted {
            let most = port.absorbed + 1e-12;
            assert!(told.observed_energy <= most, "{most} J absorbed: {}", place());
            risen = if silent > HOLD { 1 } else { risen + 1 };
            let share = (risen as f64 / RISE as f64).min(1.0);
            let given = share * asked + told.alpha * sample.velocity;
            assert_relative_eq!(told.effort, given, max_relative = 1e-9, epsilon = 1e-12);
            silent = 0;
        } else {
            silent += 1;
            let held = if silent <= HOLD { applied } else { 0.0 };
            assert_eq!(told.effort, held, "{}", place());
        }
        applied = told.effort;
        port.moves(applied);
    }
}

/// A force is held for the stated ticks, then let go, and rises again; no more is counted than was absorbed.
#[test]
fn what_is_noticed_is_held_and_not_overstated() {
    use Fault::*;
    let unbounded = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    let mut faults = vec![Missed];
    faults.extend(unbounded.into_iter().chain([f64::MAX, -f64::MAX]).map(Position));
    faults.extend(unbounded.into_iter().chain([0.0, -1.0]).map(Clock));
    for fault in faults {
        for at in 1..TICKS {
            for length in [1, HOLD, HOLD + 3] {
                check(fault, at, length);
            }
        }
    }
}
