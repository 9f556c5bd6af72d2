//! Samples of a measured plant against those of the plant itself.

use approx::{abs_diff_eq, assert_abs_diff_eq};
use lyapunov::{
    DampingLimit, Dissipation, Lolc, Observer, Plant, PortEnergy, Scalar, Stabilizer,
    integrators::RungeKutta4,
    models::{
        AffinePlant, MeasuredPlant, QuadraticForm, UprightEnergy, VanDerPol, WithState, decrease_of,
    },
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
    // A period is the time since the last call, also of the next one.
    assert_eq!((bad.period, port.tell(Vector2::new(0.1, f64::NAN), none).period), (0.01, 0.01));
    let good = port.tell(Vector2::new(0.12, 1.0), none);
    assert!(good.finite() && abs_diff_eq!(good.period, 0.03, epsilon = 1e-15));
    assert_abs_diff_eq!(good.displacement.input[0], 0.03, epsilon = 1e-15);
    assert_abs_diff_eq!(good.displacement.state[0], 0.02, epsilon = 1e-15);
    assert_eq!(port.tell(Vector2::new(0.13, 1.0), none).period.lane(0), 0.01);
}

/// A port whose first state is lost begins with the next.
#[test]
fn after_a_first_state_that_is_not_finite_the_next_begins() {
    let energy = UprightEnergy::new(pendulum::<f64>(), 6.0).expect("an energy");
    let lost = Vector2::new(f64::NAN, 0.0);
    let mut port = MeasuredPlant::new(pendulum(), energy, 0.01, lost).expect("a port");
    let mut whole =
        MeasuredPlant::new(pendulum(), energy, 0.01, Vector2::new(0.1, 1.0)).expect("a port");
    let input = Vector1::new(2.0);
    assert!(!port.start().finite() && !port.tell(lost, input).finite());
    let first = port.tell(Vector2::new(0.1, 1.0), input);
    assert!(first.finite());
    let none = WithState { input: Vector1::new(0.0), state: Vector2::zeros() };
    assert_eq!((first.displacement, first.work), (none, none));
    let next = Vector2::new(0.11, 0.9);
    assert_eq!(port.tell(next, input), whole.tell(next, input));
}

/// A free mass of 1 kg in the well `(x² + v²) / 2`: the flow is its velocity. A damper of 0.5 N·s/m on it is credited with one
/// period after a first state that was lost, and over a gap with no more than the mean flow dissipated.
#[test]
fn a_gap_earns_no_more_than_its_mean_flow() {
    let (period, circle, lost) = (0.01, QuadraticForm::sum_of_squares(), f64::NAN);
    let free = VanDerPol::new(0.0).expect("a plant");
    let earned = |start: f64, told: &[f64]| {
        let mut port =
            MeasuredPlant::new(free, circle, period, Vector2::new(0.0, start)).expect("a port");
        let mut observer = Observer::of((PortEnergy, Dissipation::of(0.5).expect("a damping")));
        let mut energy = 0.0;
        for &velocity in told {
            let sample = port.tell(Vector2::new(0.0, velocity), Vector1::new(0.0));
            energy = observer.observe(&sample, WithState::of_input(Vector1::new(0.0)));
        }
        energy
    };
    let lost_for_a_second = [&[lost; 100][..], &[1.0]].concat();
    assert_abs_diff_eq!(earned(lost, &lost_for_a_second), 0.5 * 0.01, epsilon = 1e-15);
    // From 0 to 1 m/s within two periods: 0.5 m/s in the mean.
    assert_abs_diff_eq!(earned(0.0, &[lost, 1.0]), 0.5 * 0.25 * 0.02, epsilon = 1e-15);
    // From 1 to 0.2 m/s: the last is the smaller one.
    assert_abs_diff_eq!(earned(1.0, &[lost, 0.2]), 0.5 * 0.04 * 0.02, epsilon = 1e-15);
    // From 1 to −0.2 m/s: 0.4 m/s in the mean, the other way.
    assert_eq!(earned(1.0, &[lost, -0.2]), 0.0);
    assert_abs_diff_eq!(earned(0.0, &[1.0]), 0.5 * 0.01, epsilon = 1e-15);
}

/// A mass of 1 kg in the well `(x² + v²) / 2` moves at −1 m/s; the efforts of the gap are told one by one.
fn work_of_gap(told: &[(f64, f64)]) -> f64 {
    let (period, circle) = (0.01, QuadraticForm::sum_of_squares());
    let free = VanDerPol::new(0.0).expect("a plant");
    let mut port =
        MeasuredPlant::new(free, circle, period, Vector2::new(0.5, -1.0)).expect("a port");
    let mut observer = Observer::of(PortEnergy);
    let mut energy = 0.0;
    for &(position, effort) in told {
        let state = Vector2::new(position, if position.is_nan() { f64::NAN } else { -1.0 });
        let sample = port.tell(state, Vector1::new(-effort));
        energy = observer.observe(&sample, WithState::of_input(Vector1::new(0.0)));
    }
    energy
}

/// An effort that acted within a gap is booked with the sample that spans it: over `∫ y dt = −1 m/s · t` the largest effort
/// counts against the port, and the least for it where the flow goes the other way.
#[test]
fn a_gap_forgives_no_debt() {
    let (lost, twice) = (f64::NAN, 2.0 * 0.01);
    for (told, expected) in [
        // Sound samples: 5 N over one period, and nothing over the next.
        (&[(0.49, 5.0), (0.48, 0.0)][..], -5.0 * 0.01),
        // 5 N, held or not: the port may have given as much over both.
        (&[(lost, 5.0), (0.48, 5.0)], -5.0 * twice),
        (&[(lost, 5.0), (0.48, 0.0)], -5.0 * twice),
        (&[(lost, 0.0), (0.48, 5.0)], -5.0 * twice),
        // What the port took is not counted for more than the least.
        (&[(lost, -5.0), (0.48, -2.0)], 2.0 * twice),
        // An effort that is not told is one of the others, and its tick is booked once.
        (&[(lost, 5.0), (0.48, lost), (0.47, 1.0)], -5.0 * 1.5 * twice),
        (&[(0.49, 2.0), (0.48, lost), (0.47, 1.0)], -2.0 * (0.01 + twice)),
    ] {
        let found = work_of_gap(told);
        assert!(abs_diff_eq!(found, expected, epsilon = 1e-15), "{found} J, {told:?}");
    }
}

/// In `f32` a position of 20 km still takes a millimetre a tick.
#[test]
fn a_long_way_in_single_precision() {
    let circle = QuadraticForm::<f32, 2>::sum_of_squares();
    let oscillator = VanDerPol::new(1.0_f32).expect("an oscillator");
    let state = Vector2::new(0.0, 1.0);
    let mut port = MeasuredPlant::new(oscillator, circle, 1e-3, state).expect("a port");
    let told = (0..20_000_000).map(|_| port.tell(state, Vector1::new(2.0))).last().expect("ticks");
    assert_abs_diff_eq!(told.position.input[0], 20_000.0, epsilon = 0.01);
    assert_abs_diff_eq!(told.displacement.input[0], 1e-3, epsilon = 1e-9);
    assert_abs_diff_eq!(told.work.input[0], -2e-3, epsilon = 1e-9);
}
