//! Samples against fine integrations written here.

use approx::{abs_diff_eq, assert_abs_diff_eq};
use lyapunov::laws::{self, Samples};
use lyapunov::{
    LyapunovCandidate, Plant, PortEnergy, PortSample,
    integrators::RungeKutta4,
    models::{
        AffinePlant, ArmEnergy, ControlAffine, Decay, LyapunovFunction, UprightEnergy, WithFlow,
        WithState, decrease_of,
    },
};
use nalgebra::{SVector, Vector1, Vector2, Vector4};

use crate::{Draw, arm, pendulum};

const STIFFNESS: f64 = 6.0;
const GRAVITY: f64 = 9.80665;

/// One period of the pendulum of [`pendulum`] under a held torque, by the explicit midpoint rule in many steps, with
/// the integrals of the rate and of the drift's part of V̇.
fn fine([mut angle, mut rate]: [f64; 2], torque: f64, period: f64) -> ([f64; 2], f64, f64) {
    let (inertia, weight, damping) = (0.5 * 0.4 * 0.4, 0.5 * GRAVITY * 0.4, 0.002);
    let turned = |angle: f64, rate: f64| (weight * angle.sin() - damping * rate + torque) / inertia;
    let steps = 2000;
    let step = period / f64::from(steps);
    let (mut swept, mut drifted) = (0.0, 0.0);
    for _ in 0..steps {
        let half = [angle + 0.5 * step * rate, rate + 0.5 * step * turned(angle, rate)];
        angle += step * half[1];
        rate += step * turned(half[0], half[1]);
        swept += step * half[1];
        drifted += step * (STIFFNESS * half[0] * half[1] - damping * half[1] * half[1]);
    }
    ([angle, rate], swept, drifted)
}

#[test]
fn flow_work_and_drift_of_a_pendulum_are_those_of_a_fine_integration() {
    let energy = UprightEnergy::new(pendulum(), STIFFNESS).expect("an energy");
    let start = Vector2::new(0.3, -0.5);
    let mut plant = AffinePlant::new(pendulum(), energy, RungeKutta4, 0.01, 4)
        .expect("a plant")
        .starting(start);
    let (mut candidate, mut draw) = (decrease_of(energy, start), Draw(1));
    for _ in 0..300 {
        // Kept near upright, or it would fall.
        let at = plant.state();
        let torque = -8.0 * at[0] - 0.3 * at[1] + draw.next();
        let (truth, swept, drifted) = fine([at[0], at[1]], torque, 0.01);
        let sample = plant.advance(WithState::of_input(Vector1::new(-torque)));
        assert_abs_diff_eq!(sample.position.state[0], truth[0], epsilon = 1e-8);
        assert_abs_diff_eq!(sample.position.state[1], truth[1], epsilon = 1e-7);
        assert!(
            abs_diff_eq!(sample.velocity.input[0], truth[1], epsilon = 1e-7),
            "the flow is the rate"
        );
        assert_abs_diff_eq!(sample.displacement.input[0], swept, epsilon = 1e-8);
        let worked = PortEnergy.decrease(&sample);
        assert_abs_diff_eq!(worked, -torque * swept, epsilon = 1e-7);
        // V̇ = L_f V + y u, over the tick.
        let lost = candidate.decrease(&sample);
        assert!(
            abs_diff_eq!(lost, worked - drifted, epsilon = 1e-7),
            "{lost} is not {worked} - {drifted}"
        );
    }
}

#[test]
fn a_damper_lowers_the_rate_of_v_by_what_it_takes() {
    let arm = arm();
    let energy = ArmEnergy::new(arm, [40.0, 10.0]).expect("an energy");
    let mut draw = Draw(2);
    for _ in 0..1000 {
        let (state, input): (Vector4<f64>, Vector2<f64>) = (draw.vector(1.0), draw.vector(20.0));
        let flow = arm.flow(&energy, state);
        // The flow of an energy under torques is the joints' rates.
        assert!((flow - Vector2::new(state[2], state[3])).norm() < 1e-12);
        let rate_of_v = |input| energy.gradient(state).dot(&arm.rate(state, input));
        let alpha = 1.0 + draw.next();
        let gained = rate_of_v(input - flow * alpha) - rate_of_v(input);
        assert_abs_diff_eq!(gained, -alpha * flow.norm_squared(), epsilon = 1e-9);
    }
}

#[test]
fn decreases_telescope_and_decay_is_a_debit() {
    let energy = UprightEnergy::new(pendulum(), STIFFNESS).expect("an energy");
    let start = Vector2::new(0.3, -0.5);
    let mut plant = AffinePlant::new(pendulum(), energy, RungeKutta4, 0.01, 4)
        .expect("a plant")
        .starting(start);
    let mut drives = vec![plant.start()];
    for _ in 0..500 {
        let at = plant.state();
        drives.push(plant.advance(WithState::of_input(Vector1::new(8.0 * at[0] + 0.3 * at[1]))));
    }
    let value = |sample: &PortSample<WithState<f64, 2, 1>>| energy.value(sample.position.state);
    let candidate = decrease_of(energy, start);
    laws::decrease(&candidate, value, drives.iter().copied(), 0.0).expect("telescopes");
    laws::candidate(&candidate, drives.iter().map(|&sample| (sample, sample.applied)))
        .expect("a candidate");
    let decay = Decay::new(energy, 3.0).expect("a rate");
    let broken = laws::decrease(&(candidate, decay), value, drives.iter().copied(), 0.1);
    assert_eq!(broken.expect_err("a debit").law, laws::Law::AddsUp);
    let (mut asked, mut by_hand) = (decay, 0.0);
    let told: f64 = drives.iter().map(|sample| asked.decrease(sample)).sum();
    for sample in &drives {
        by_hand -= 3.0 * energy.value(sample.position.state) * 0.01;
    }
    assert!(abs_diff_eq!(told, by_hand, epsilon = 1e-12) && told < 0.0);
}

/// A candidate by rates keeps the law within the error of its quadrature, and not within a tenth of it.
#[test]
fn a_sum_of_rates_is_as_accurate_as_its_quadrature() {
    #[derive(Clone, Copy)]
    struct ByRate;
    impl LyapunovCandidate<WithState<f64, 2, 1>> for ByRate {
        fn decrease(&mut self, sample: &PortSample<WithState<f64, 2, 1>>) -> f64 {
            let energy = UprightEnergy::new(pendulum(), STIFFNESS).expect("an energy");
            let state = sample.position.state;
            let rate = energy.gradient(state).dot(&pendulum().rate(state, -sample.applied.input));
            -rate * sample.period
        }
    }
    let energy = UprightEnergy::new(pendulum(), STIFFNESS).expect("an energy");
    let mut plant = AffinePlant::new(pendulum(), energy, RungeKutta4, 1e-3, 1)
        .expect("a plant")
        .starting(Vector2::new(0.3, 1.0));
    let mut drives = vec![plant.start()];
    for _ in 0..2000 {
        let at = plant.state();
        drives.push(plant.advance(WithState::of_input(Vector1::new(8.0 * at[0] + 0.1 * at[1]))));
    }
    let value = |sample: &PortSample<WithState<f64, 2, 1>>| energy.value(sample.position.state);
    laws::decrease(&ByRate, value, drives.iter().copied(), 0.05).expect("within a twentieth");
    laws::decrease(&ByRate, value, drives, 1e-4).expect_err("but not as by differences");
}

#[test]
fn affine_plants_keep_the_laws_of_a_plant_and_the_integrator_its_own() {
    fn small<const N: usize, const M: usize>()
    -> impl Iterator<Item = (PortSample<WithState<f64, N, M>>, WithState<f64, N, M>)> {
        Samples::new(1e-3).map(|(sample, effort): (_, WithState<f64, N, M>)| {
            (sample, WithState::of_input(SVector::from(effort.input.data.0[0].map(|e| e * 1e-4))))
        })
    }
    let energy = UprightEnergy::new(pendulum(), STIFFNESS).expect("an energy");
    let plant = AffinePlant::new(pendulum(), energy, RungeKutta4, 1e-3, 2).expect("a plant");
    laws::plant(&plant, small::<2, 1>()).expect("the pendulum");
    let springs = ArmEnergy::new(arm(), [40.0, 10.0]).expect("an energy");
    let plant = AffinePlant::new(arm(), springs, RungeKutta4, 1e-3, 2).expect("a plant");
    laws::plant(&plant, small::<4, 2>()).expect("the arm");

    let dynamics = WithFlow { plant: pendulum(), function: energy };
    let from = WithState { input: Vector1::new(0.0), state: Vector2::new(0.4, -1.0) };
    let push = Vector1::new(0.7);
    laws::integrator(&RungeKutta4, &dynamics, [(from, push)], 0.2, 4).expect("of order 4");
}
