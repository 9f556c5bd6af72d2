//! Samples of a measured plant against those of the plant itself.

use approx::{abs_diff_eq, assert_abs_diff_eq};
use lyapunov::{
    DampingLimit, Lolc, Plant, Scalar, Stabilizer,
    integrators::RungeKutta4,
    models::{AffinePlant, MeasuredPlant, UprightEnergy, WithState, decrease_of},
};
use nalgebra::{Vector1, Vector2};

use crate::{Draw, pendulum};

#[test]
fn measured_samples_are_the_plants_with_the_integral_by_trapezoids() {
    let energy = UprightEnergy::new(pendulum(), 6.0).expect("an energy");
    let start = Vector2::new(0.2, 0.0);
    let period = 1e-3;
    let mut plant = AffinePlant::new(pendulum(), energy, RungeKutta4, period, 1)
        .expect("a plant")
        .starting(start);
    let mut port = MeasuredPlant::new(pendulum(), energy, period, start).expect("a port");
    let limit = DampingLimit::of_mass(0.5, 0.08, period).expect("a limit");
    let (mut one, mut other) = (
        Lolc::new(decrease_of(energy, start), limit),
        Lolc::new(decrease_of(energy, start), limit),
    );
    assert_eq!(port.start(), plant.start());
    let (mut told, mut draw) = (port.start(), Draw(12));
    let mut truth = plant.start();
    let mut injected = 0;
    for _ in 0..3000 {
        let state = plant.state();
        let wanted = 6.0 * state[0] - 0.1 * state[1] + 0.1 * draw.next();
        let correction = one.stabilize(&told, WithState::of_input(Vector1::new(wanted)));
        let same = other.stabilize(&truth, WithState::of_input(Vector1::new(wanted)));
        // Sums by differences of V use only the states, so the two stabilizers agree to the bit.
        assert_eq!(correction.observed_energy.to_bits(), same.observed_energy.to_bits());
        assert_eq!(correction.effort, same.effort);
        injected += usize::from(correction.alpha > 0.0);
        truth = plant.advance(correction.effort);
        told = port.tell(plant.state(), -correction.effort.input);
        assert_eq!((told.velocity, told.applied), (truth.velocity, truth.applied));
        let apart = (told.displacement.input - truth.displacement.input).norm();
        // T³ ÿ / 12, with an ÿ of some thousands at most while the damper switches.
        assert!(apart < 1e-9 * 1e3, "{apart:e}");
    }
    assert!(injected > 100, "{injected}");
}

#[test]
fn after_a_state_that_is_not_finite_the_next_spans_the_gap() {
    let energy = UprightEnergy::new(pendulum::<f64>(), 6.0).expect("an energy");
    let mut port =
        MeasuredPlant::new(pendulum(), energy, 0.01, Vector2::new(0.1, 1.0)).expect("a port");
    let none = Vector1::new(0.0);
    let bad = port.tell(Vector2::new(f64::NAN, 1.0), none);
    assert!(!bad.finite());
    let good = port.tell(Vector2::new(0.12, 1.0), none);
    assert!(good.finite() && abs_diff_eq!(good.period, 0.02, epsilon = 1e-15));
    assert_abs_diff_eq!(good.displacement.input[0], 0.02, epsilon = 1e-15);
    assert_abs_diff_eq!(good.displacement.state[0], 0.02, epsilon = 1e-15);
    assert_eq!(port.tell(Vector2::new(0.13, 1.0), none).period.lane(0), 0.01);
}
