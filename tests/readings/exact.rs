//! The first tick, and work against its closed form.

use nalgebra::Vector3;

use lyapunov::{
    DampingLimit, Dissipation, Lolc, Observer, PortEnergy, PortSample, Signal, Stabilizer,
};

use crate::support::{PERIOD, reading, readings};

/// An arm at 0.3 m on the first tick of a 1 kHz loop, and a credited damper of 0.6 N·s/m: a last position of 0 is
/// a velocity of 300 m/s, and `b v² T = 54` J.
#[test]
fn the_first_tick_books_nothing_wherever_the_arm_stands() {
    let period = 1e-3;
    let limit = DampingLimit::of_mass(0.5, 0.2, period).expect("a limit");
    let lolc = Lolc::new((PortEnergy, Dissipation::of(0.6).expect("a damper")), limit);

    let (position, last) = (0.3_f64, 0.0);
    let moved = position - last;
    let velocity = moved / period;
    let wrong =
        PortSample { period, position, velocity, displacement: moved, applied: 0.0, work: 0.0 };
    let by_hand: f64 = { lolc }.stabilize(&wrong, 0.0).observed_energy;
    assert!((by_hand - 54.0).abs() < 1e-9, "{by_hand} J");

    let mut readings = lyapunov::Readings::<f64>::every(period).expect("a period");
    let first = readings.read(reading(position, 0.0));
    assert!(first.accepted && !first.late && !first.jumped && first.timed);
    assert_eq!({ lolc }.stabilize(&first.sample, 0.0).observed_energy, 0.0);
}

/// A held force over a path of whole counts: `Σ f Δx = f (x(n) − x(0))`, to the bit, since every number is a short one.
#[test]
fn a_constant_force_does_force_times_way() {
    let force = Vector3::new(3.0, -5.0, 0.5);
    let (start, count) = (Vector3::new(0.25, -1.0, 7.0), 1.0 / 4096.0);
    let mut readings = readings::<Vector3<f64>>();
    let mut observer = Observer::of(PortEnergy);
    let mut applied = Vector3::zeros();
    for tick in 0..1000 {
        let n = f64::from(tick);
        let way = Vector3::new(n, (n * 17.0) % 256.0, -n * n);
        let position = start + way * count;
        let checked = readings.read(reading(position, applied));
        let observed = observer.observe(&checked.sample, applied);
        assert_eq!(observed, force.inner(position - start), "at tick {tick}");
        applied = force;
    }
}

/// Without gaps the samples are those of the loop written by hand, to the bit.
#[test]
fn without_gaps_samples_are_those_by_hand() {
    let mut readings = readings::<f64>();
    let path = |tick: i32| 0.01 * (0.37 * f64::from(tick)).sin();
    let force = |tick: i32| 4.0 * (0.11 * f64::from(tick)).cos();
    let (mut last, mut applied) = (path(0), 0.0);
    for tick in 0..500 {
        let position = path(tick);
        let displacement = position - last;
        last = position;
        let velocity = displacement / PERIOD;
        let work = applied * displacement;
        let by_hand =
            PortSample { period: PERIOD, position, velocity, displacement, applied, work };
        assert_eq!(readings.read(reading(position, applied)).sample, by_hand, "at tick {tick}");
        applied = force(tick);
    }
}

#[test]
fn periods_and_speeds_are_checked() {
    for bad in [0.0, -1e-3, f64::NAN, f64::INFINITY] {
        let refused = lyapunov::Readings::<f64>::every(bad).expect_err("a bad period");
        assert_eq!(refused.parameter, "period");
    }
    for bad in [0.0, -1.0, f64::NAN] {
        let refused = readings::<f64>().no_faster_than(bad).expect_err("a bad speed");
        assert_eq!(refused.parameter, "fastest motion");
        let told = refused.to_string();
        assert!(told.ends_with("; it must be above 0 (infinity: no limit)"), "{told}");
    }
    assert!(readings::<f64>().no_faster_than(f64::INFINITY).is_ok());
}
