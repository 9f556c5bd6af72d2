//! Jumps that no device can make.

use nalgebra::Vector2;

use crate::support::{PERIOD, reading, readings};

/// A glitch of one tick is rejected and told, and books nothing.
#[test]
fn a_glitch_is_rejected() {
    let mut readings = readings::<f64>().no_faster_than(2.0).expect("a speed");
    readings.read(reading(0.3, 0.0));
    for glitch in [0.0, -0.3, 0.3 + 2.1 * PERIOD, 1e300, -1e308] {
        let lost = readings.read(reading(glitch, 5.0));
        assert!(lost.jumped && !lost.accepted, "{glitch}");
        assert_eq!(lost.sample.position, 0.3);
        let back = readings.read(reading(0.3, 5.0));
        assert!(back.accepted && !back.jumped);
        assert_eq!(back.sample.work, 0.0);
    }
    assert!(readings.read(reading(0.3 + 1.9 * PERIOD, 5.0)).accepted);
}

/// The speed is that of the whole motion, not of an axis.
#[test]
fn the_speed_is_a_length() {
    for (way, jumps) in [(0.69, false), (0.72, true)] {
        let mut readings = readings::<Vector2<f64>>().no_faster_than(1.0).expect("a speed");
        readings.read(reading(Vector2::zeros(), Vector2::zeros()));
        let diagonal = Vector2::new(way, way) * PERIOD;
        assert_eq!(readings.read(reading(diagonal, Vector2::zeros())).jumped, jumps);
    }
}

/// A jump that stays is accepted once the time since the last reading allows it, and its work is that of the least effort
/// in between.
#[test]
fn a_jump_that_stays_becomes_a_motion() {
    let mut readings = readings::<f64>().no_faster_than(1.0).expect("a speed");
    readings.read(reading(0.0, 0.0));
    let jump = 9.5 * PERIOD;
    for tick in 1..10 {
        let lost = readings.read(reading(jump, if tick == 1 { 8.0 } else { 0.0 }));
        assert!(lost.jumped && !lost.accepted, "tick {tick}");
    }
    let found = readings.read(reading(jump, 0.0));
    assert!(found.accepted && found.late);
    assert_eq!(found.sample.period, 10.0 * PERIOD);
    assert_eq!(found.sample.work, 0.0); // no credit for a force that may have acted elsewhere
}

/// Positions whose difference is out of range are a jump, whatever the limit.
#[test]
fn a_difference_out_of_range_is_a_jump() {
    let mut readings = readings::<f64>();
    readings.read(reading(1e308, 0.0));
    let lost = readings.read(reading(-1e308, 0.0));
    assert!(lost.jumped && !lost.accepted);
}

/// After a restart the next reading displaces nothing, wherever it is, in every estimator.
#[test]
fn a_restart_forgets_the_position() {
    let mut low_passed = readings::<f64>().low_passed(20.0).expect("a cutoff");
    let mut windowed = readings::<f64>().windowed::<8>(8, 1e-4).expect("a window");
    for tick in 0..20 {
        let moving = reading(0.001 * f64::from(tick), 1.0);
        low_passed.read(moving);
        windowed.read(moving);
    }
    low_passed.restart();
    windowed.restart();
    for position in [5.0, 5.0, 5.0] {
        for sample in
            [low_passed.read(reading(position, 1.0)), windowed.read(reading(position, 1.0))]
        {
            let sample = sample.sample;
            assert_eq!([sample.displacement, sample.velocity, sample.work], [0.0; 3]);
        }
    }
}
