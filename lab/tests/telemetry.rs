//! A ring of ticks as a log: `observe` reads it and finds the energy that the stabilizer's own ledger holds.

use approx::assert_relative_eq;
use lyapunov::telemetry::{EnergyMeter, TickRing};
use lyapunov::{
    Correction, DampingLimit, HeldTick, OnePort, Plant, Popc, PortEnergy, PortSample, Signal,
    bodies::{Body, Impedance},
    effects::OnePortExt,
    environments::{Contact, Plane, Wall},
};
use lyapunov_lab::observe::{Report, Settings, observe};
use nalgebra::Vector2;

const PERIOD: f64 = 1e-3;

fn read(csv: &str, columns: &str) -> Report {
    let columns = columns.parse().expect("columns");
    let settings = Settings { columns, ..Settings::default() };
    observe(csv.as_bytes(), "ring", &settings).expect("a log").report
}

/// A hand on a stiff wall, watched by POPC behind a saturation and a delay of one tick.
fn recorded<const N: usize>(ticks: usize) -> (TickRing<f64, N>, EnergyMeter<f64>) {
    let hand = Impedance { mass: 0.3, damping: 0.2, stiffness: 50.0 };
    let mut body = Body::new(hand, PERIOD).expect("a body").starting(-0.004, 0.0);
    let popc = Popc::new(PortEnergy, DampingLimit::of_mass(0.5, 0.3, PERIOD).expect("a limit"));
    let wall = Wall::new(8000.0, 2.0).and_then(|wall| wall.held(10)).expect("a wall");
    let port = wall.stabilized(popc).saturated(3.0).expect("a saturation");
    let mut port = port.delayed::<2>(1).expect("a delay").differenced();
    let (mut ring, mut meter) = (TickRing::new(), EnergyMeter::new());
    let mut sample = body.start();
    for _ in 0..ticks {
        let effort = port.respond(&sample);
        let correction = OnePort::<f64>::correction(&port);
        ring.push(&sample, &correction);
        meter.add(&sample, &correction);
        sample = body.advance(effort);
    }
    (ring, meter)
}

#[test]
fn the_log_holds_the_energy_of_the_ledger() {
    let (ring, meter) = recorded::<4000>(3000);
    let (report, summary) = (read(&ring.csv().to_string(), "t,x,f"), meter.summary());
    assert_eq!((report.rows, report.bad_rows.count, report.gaps.count), (3000, 0, 0));
    assert_relative_eq!(report.observed_energy.last, summary.now, max_relative = 1e-9);
    assert_relative_eq!(report.observed_energy.last, summary.absorbed, max_relative = 1e-9);
    assert_relative_eq!(report.observed_energy.lowest, summary.least, max_relative = 1e-9);
    assert!(summary.least < -1e-4, "nothing happened: {summary:?}");
    let speed = read(&ring.csv().to_string(), "t,x,f,v");
    assert_relative_eq!(speed.observed_energy.last, summary.now, max_relative = 1e-9);
}

/// What went before is missing, and nothing else is.
#[test]
fn a_ring_that_came_round_holds_the_difference() {
    let (ring, _) = recorded::<500>(3000);
    let report = read(&ring.csv().to_string(), "t,x,f");
    assert_eq!(report.rows, 500);
    let energies: Vec<f64> = ring.iter().map(|tick| tick.correction.observed_energy).collect();
    let gained = energies[499] - energies[0];
    assert!(gained.abs() > 1e-6, "nothing happened: {gained}");
    assert_relative_eq!(report.observed_energy.last, gained, max_relative = 1e-6);
}

/// Each axis is a log of its own, and their energies add up to that of the port.
#[test]
fn the_axes_add_up() {
    let plane = Plane::new(Vector2::zeros(), Vector2::new(-1.0, -0.5)).expect("a plane");
    let contact = Contact::with(plane, 5000.0, 0.0).expect("a contact");
    let popc = Popc::new(PortEnergy, DampingLimit::of_mass(0.5, 0.3, PERIOD).expect("a limit"));
    let mut port = contact.stabilized(popc);
    let mut ring = TickRing::<Vector2<f64>, 2000>::new();
    let (mut at, mut v) = (Vector2::new(-0.002, 0.0), Vector2::new(0.05, 0.03));
    let (mut applied, mut moved) = (Vector2::zeros(), Vector2::zeros());
    for _ in 0..2000 {
        let velocity = moved.scale(1.0 / PERIOD);
        let tick =
            HeldTick { period: PERIOD, position: at, velocity, displacement: moved, applied };
        let sample = tick.sample();
        applied = port.respond(&sample);
        ring.push(&sample, &OnePort::<Vector2<f64>>::correction(&port));
        v -= (applied + at * 50.0) * (PERIOD / 0.3);
        moved = v * PERIOD;
        at += moved;
    }
    let csv = ring.csv().to_string();
    let [x, y] = ["t,x,f", "t,y,y_f"].map(|columns| read(&csv, columns).observed_energy.last);
    let last: Correction<Vector2<f64>> = ring.iter().last().expect("a tick").correction;
    assert!(x != 0.0 && y != 0.0);
    assert_relative_eq!(x + y, last.observed_energy, epsilon = 1e-12, max_relative = 1e-9);
}

/// A tick that was rejected is a bad row, and the log goes on.
#[test]
fn a_bad_tick_is_a_bad_row() {
    let mut ring = TickRing::<f64, 8>::new();
    let popc = Popc::<f64>::new(PortEnergy, DampingLimit::at(100.0).expect("a limit"));
    let mut port = Wall::new(8000.0, 0.0).expect("a wall").stabilized(popc);
    for (tick, position) in [0.0, 1e-4, f64::NAN, 3e-4, 4e-4].into_iter().enumerate() {
        let sample = PortSample::starting(PERIOD, position, 0.0);
        let _ = port.respond(&sample);
        ring.push(&sample, &OnePort::<f64>::correction(&port));
        let accepted = ring.iter().nth(tick).expect("a tick").correction.accepted;
        assert_eq!(accepted, position.finite());
    }
    let report = read(&ring.csv().to_string(), "t,x,f");
    assert_eq!((report.rows, report.bad_rows.count), (4, 1));
}
