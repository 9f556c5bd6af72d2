//! Time of oscillating environments, by the count of their calls.

use std::f64::consts::TAU;

use approx::{abs_diff_eq, assert_abs_diff_eq};
use lyapunov::{
    LyapunovCandidate, OnePort, PortSample,
    environments::{MovingWall, Spring, VaryingSpring, Wall},
};

use crate::support::Double;

/// The turn of `frequency n / rate`, in 32 digits, and so without the rounding of many turns.
fn turn(frequency: f64, rate: f64, n: u32) -> f64 {
    let turns = Double::product(frequency, f64::from(n)).over(Double::of(rate));
    (turns - Double::of(turns.value().floor())).value()
}

/// After 1e4 s at 100 Hz: within 1e-12 of the amplitude of the formula in `f64`, and of the true sine within the
/// rounding of the phase.
#[test]
fn a_phase_does_not_drift() {
    let rate = 100.0;
    for frequency in [0.1, 1.0, 7.3, 33.3] {
        let none = Spring::new(0.0).expect("a spring");
        let mut spring = VaryingSpring::new(none, 1.0, frequency, rate).expect("it varies");
        let still = PortSample::starting(1.0 / rate, 1.0, 0.0);
        for n in 0..=1_000_000u32 {
            let found: f64 = spring.respond(&still);
            let phase = TAU * (frequency * (f64::from(n) / rate));
            assert!(
                abs_diff_eq!(found, phase.sin(), epsilon = 1e-12),
                "{n} at {frequency} Hz: {found}"
            );
            let exact = (TAU * turn(frequency, rate, n)).sin();
            let rounding = 2f64.powi(-53) * (4.0 * phase + 16.0);
            assert!(
                abs_diff_eq!(found, exact, epsilon = rounding),
                "{n} at {frequency} Hz: {found}, {exact}"
            );
        }
    }
}

/// An observer that is asked ten times as often as the wall sees the same surface.
#[test]
fn the_credit_has_a_rate_of_its_own() {
    let (amplitude, frequency, damping) = (0.01, 3.0, 2.0);
    let wall = Wall::new(0.0, damping).expect("a damper with a surface");
    let mut moving = MovingWall::new(wall, amplitude, frequency, 100.0).expect("it moves");
    let mut credit = moving.dissipation(1000.0).expect("its damper");
    for tick in 0..5000 {
        let t = f64::from(tick) / 1000.0;
        let (velocity, phase) = (1.5, TAU * frequency * t);
        let sample = PortSample::starting(1e-3, 0.002, velocity);
        let relative = velocity - TAU * frequency * amplitude * phase.cos();
        let depth = 0.002 - amplitude * phase.sin();
        let burnt = if depth > 0.0 { damping * relative * relative * 1e-3 } else { 0.0 };
        assert_abs_diff_eq!(credit.decrease(&sample), burnt, epsilon = 1e-12);
        if tick % 10 == 0 {
            let force = if depth > 0.0 { damping * relative } else { 0.0 };
            assert!(abs_diff_eq!(moving.respond(&sample), force, epsilon = 1e-12), "at {tick}");
            // Made from a wall that is already moving, a credit still begins at the first tick.
            let mut fresh = moving.dissipation(1000.0).expect("its damper");
            let relative = velocity - TAU * frequency * amplitude;
            let first = damping * relative * relative * 1e-3;
            assert_abs_diff_eq!(fresh.decrease(&sample), first, epsilon = 1e-12);
        }
    }
}
