//! Port without drift, which is that of the passivity observer.

use approx::{abs_diff_eq, assert_abs_diff_eq};
use lyapunov::{
    DampingLimit, HeldTick, Lolc, LyapunovCandidate, Plant, Popc, PortEnergy, Stabilizer,
    bodies::{Body, Impedance},
    integrators::RungeKutta4,
    models::{AffinePlant, ControlAffine, QuadraticForm, WithState, decrease_of},
};
use nalgebra::{Vector1, Vector2};

use crate::Draw;

const MASS: f64 = 0.3;

/// A mass that only its input moves; the state is its velocity.
#[derive(Clone, Copy, Debug)]
struct FreeMass;

impl ControlAffine<f64, 1, 1> for FreeMass {
    fn drift(&self, _state: Vector1<f64>) -> Vector1<f64> {
        Vector1::new(0.0)
    }

    fn input_fields(&self, _state: Vector1<f64>) -> [Vector1<f64>; 1] {
        [Vector1::new(1.0 / MASS)]
    }
}

/// A driftless plant whose fields turn with the state.
#[derive(Clone, Copy, Debug)]
struct Turning;

impl ControlAffine<f64, 2, 2> for Turning {
    fn drift(&self, _state: Vector2<f64>) -> Vector2<f64> {
        Vector2::zeros()
    }

    fn input_fields(&self, x: Vector2<f64>) -> [Vector2<f64>; 2] {
        [Vector2::new(1.0 + x[1] * x[1], x[0]), Vector2::new(-x[0] * x[1], 2.0)]
    }
}

fn kinetic() -> QuadraticForm<f64, 1> {
    QuadraticForm::new([Vector1::new(MASS)]).expect("a mass")
}

fn limit() -> DampingLimit<f64> {
    DampingLimit::of_mass(0.5, MASS, 1e-3).expect("a limit")
}

#[test]
fn a_stabilizer_at_the_port_is_popc_on_its_numbers_bit_for_bit() {
    let mut plant = AffinePlant::new(FreeMass, kinetic(), RungeKutta4, 1e-3, 1)
        .expect("a plant")
        .starting(Vector1::new(0.2));
    let (mut at_port, mut alone): (Popc<f64>, Popc<f64>) =
        (Popc::new(PortEnergy, limit()), Popc::new(PortEnergy, limit()));
    let (mut sample, mut draw) = (plant.start(), Draw(1));
    let mut injected = 0;
    for _ in 0..5000 {
        let wanted = 3.0 * draw.next();
        let correction = at_port.stabilize(&sample, WithState::of_input(Vector1::new(wanted)));
        let scalar = HeldTick {
            period: sample.period,
            position: sample.position.input[0],
            velocity: sample.velocity.input[0],
            displacement: sample.displacement.input[0],
            applied: sample.applied.input[0],
        }
        .sample();
        let same = alone.stabilize(&scalar, wanted);
        assert_eq!(correction.observed_energy.to_bits(), same.observed_energy.to_bits());
        assert_eq!(correction.alpha.to_bits(), same.alpha.to_bits());
        assert_eq!(correction.effort.input[0].to_bits(), same.effort.to_bits());
        assert_eq!(correction.shortfall.to_bits(), same.shortfall.to_bits());
        injected += usize::from(correction.alpha > 0.0);
        sample = plant.advance(correction.effort);
    }
    assert!(injected > 100, "{injected}");
}

#[test]
fn a_free_mass_is_the_body_that_moves_exactly() {
    let mut plant = AffinePlant::new(FreeMass, kinetic(), RungeKutta4, 1e-3, 1)
        .expect("a plant")
        .starting(Vector1::new(0.2));
    let impedance = Impedance { mass: MASS, damping: 0.0, stiffness: 0.0 };
    let mut body = Body::new(impedance, 1e-3).expect("a body").starting(0.0, 0.2);
    let mut draw = Draw(2);
    for _ in 0..5000 {
        let effort = 3.0 * draw.next();
        let sample = plant.advance(WithState::of_input(Vector1::new(effort)));
        let exact = body.advance(effort);
        assert_abs_diff_eq!(sample.position.input[0], exact.position, epsilon = 1e-12);
        assert_abs_diff_eq!(sample.velocity.input[0], exact.velocity, epsilon = 1e-12);
        assert_abs_diff_eq!(sample.work.input[0], exact.work, epsilon = 1e-14);
    }
}

/// `m / T` brings the flow to 0 within a tick, twice that turns it round whole, and more makes it larger.
#[test]
fn the_most_that_a_tick_can_use_is_the_mass_over_the_period() {
    let start = Vector1::new(0.2);
    for share in [0.25, 0.5, 1.0, 1.5, 2.0, 2.5] {
        let damping = DampingLimit::of_mass(share, MASS, 1e-3).expect("a limit").most();
        let mut plant = AffinePlant::new(FreeMass, kinetic(), RungeKutta4, 1e-3, 1)
            .expect("a plant")
            .starting(start);
        let flow = plant.start().velocity.input[0];
        let after = plant.advance(WithState::of_input(Vector1::new(damping * flow)));
        let left = after.velocity.input[0] / flow;
        assert_abs_diff_eq!(left, 1.0 - share, epsilon = 1e-12);
        assert_abs_diff_eq!(plant.value(), 0.5 * MASS * (0.2 * left).powi(2), epsilon = 1e-12);
    }
}

#[test]
fn without_drift_v_loses_the_work_of_the_input() {
    let start = Vector1::new(0.2);
    let mut plant = AffinePlant::new(FreeMass, kinetic(), RungeKutta4, 1e-3, 1)
        .expect("a plant")
        .starting(start);
    let mut candidate = decrease_of(kinetic(), start);
    let mut draw = Draw(3);
    for _ in 0..5000 {
        let sample = plant.advance(WithState::of_input(Vector1::new(3.0 * draw.next())));
        let (told, worked) = (candidate.decrease(&sample), PortEnergy.decrease(&sample));
        assert!(abs_diff_eq!(told, worked, epsilon = 1e-15), "{told:e} is not {worked:e}");
    }
}

/// With curved fields only the integral of the flow errs, by its order in the step.
#[test]
fn with_curved_fields_the_two_differ_by_order_four() {
    let circle = QuadraticForm::<f64, 2>::sum_of_squares();
    let apart = |steps| {
        let start = Vector2::new(0.4, -0.3);
        let mut plant = AffinePlant::new(Turning, circle, RungeKutta4, 0.2, steps)
            .expect("a plant")
            .starting(start);
        let mut candidate = decrease_of(circle, start);
        let sample = plant.advance(WithState::of_input(Vector2::new(0.7, -0.4)));
        let worked = PortEnergy.decrease(&sample);
        assert!(worked.abs() > 0.01);
        (candidate.decrease(&sample) - worked).abs()
    };
    let ratio = apart(4) / apart(8);
    assert!(ratio > 12.0 && ratio < 40.0, "{ratio}");
}

#[test]
fn stabilized_by_both_the_same_free_mass_moves_the_same() {
    let start = Vector1::new(0.2);
    let run = |stabilizer: &mut dyn Stabilizer<WithState<f64, 1, 1>>| {
        let mut plant = AffinePlant::new(FreeMass, kinetic(), RungeKutta4, 1e-3, 1)
            .expect("a plant")
            .starting(start);
        let (mut sample, mut draw) = (plant.start(), Draw(4));
        let mut path = Vec::new();
        for _ in 0..1000 {
            let wanted = WithState::of_input(Vector1::new(-draw.next().abs()));
            sample = plant.advance(stabilizer.stabilize(&sample, wanted).effort);
            path.push(plant.state()[0]);
        }
        path
    };
    let by_work = run(&mut Popc::new(PortEnergy, limit()));
    let by_v = run(&mut Lolc::new(decrease_of(kinetic(), start), limit()));
    let apart = by_work.iter().zip(&by_v).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(apart < 1e-9, "{apart:e}");
    // A push that only feeds energy never raises the energy above its start.
    assert!(by_v.iter().all(|v| v.abs() < 0.21), "bounded");
}
