//! Order of each method, by regression against closed forms.

use approx::{abs_diff_eq, assert_abs_diff_eq};
use lyapunov::{
    Plant,
    bodies::{Impedance, TwoMassBody},
    integrators::{
        CoupledOscillators, DormandPrince5, DormandPrince8, Exact, ImplicitMidpoint, Integrator,
        Oscillator, RungeKutta4, RungeKuttaNystrom4, SemiImplicitEuler, State,
    },
};

use crate::{U, hand, moved, pair};

/// The damped oscillation `x₀ → x(t)`, `v₀ → v(t)` about its equilibrium under the held force, in closed form.
pub(crate) fn damped(parts: Impedance<f64>, [x, v]: [f64; 2], force: f64, t: f64) -> [f64; 2] {
    let Impedance { mass, damping, stiffness } = parts;
    let (middle, decay) = (-force / stiffness, damping / (2.0 * mass));
    let omega = (stiffness / mass - decay * decay).sqrt();
    let (a, b) = (x - middle, (v + decay * (x - middle)) / omega);
    let (sin, cos) = (omega * t).sin_cos();
    let shrunk = (-decay * t).exp();
    let position = shrunk * (a * cos + b * sin);
    let velocity = shrunk * omega * (b * cos - a * sin) - decay * position;
    [middle + position, velocity]
}

/// The slope of log error over log step, by least squares.
pub(crate) fn slope(errors: impl IntoIterator<Item = (f64, f64)>) -> f64 {
    let points: Vec<_> = errors.into_iter().map(|(step, error)| (step.ln(), error.ln())).collect();
    let mean =
        |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / points.len() as f64;
    let (x, y) = (mean(|point| point.0), mean(|point| point.1));
    let along: f64 = points.iter().map(|point| (point.0 - x) * (point.1 - y)).sum();
    along / points.iter().map(|point| (point.0 - x).powi(2)).sum::<f64>()
}

const START: [f64; 2] = [-0.004, 0.05];
const FORCE: f64 = 0.3;
const PERIOD: f64 = 0.3;

/// The order over one long period on the damped oscillation, by the errors of position and of velocity divided by ω.
fn order_of_one(integrator: impl Integrator<f64, Oscillator<f64>> + Copy, steps: [u32; 4]) -> f64 {
    let [x, v] = damped(hand(), START, FORCE, PERIOD);
    slope(steps.map(|steps| {
        let dynamics = Oscillator::new(hand()).expect("parts");
        let mut plant = moved(dynamics, integrator, PERIOD, steps).starting(START[0], START[1]);
        let sample = plant.advance(FORCE);
        let omega = (50.0_f64 / 0.3).sqrt();
        (1.0 / f64::from(steps), (sample.position - x).hypot((sample.velocity - v) / omega))
    }))
}

/// The same for two masses against their exact motion.
fn order_of_two(
    integrator: impl Integrator<f64, CoupledOscillators<f64>> + Copy,
    steps: [u32; 4],
) -> f64 {
    let mut exact = TwoMassBody::new(pair(), PERIOD).expect("a body").starting(START[0], START[1]);
    let true_drive = exact.advance(FORCE);
    let (operator, operator_velocity) = exact.operator();
    slope(steps.map(|steps| {
        let dynamics = CoupledOscillators::new(pair()).expect("parts");
        let mut plant = moved(dynamics, integrator, PERIOD, steps).starting(START[0], START[1]);
        let sample = plant.advance(FORCE);
        let State { position, velocity } = plant.state();
        let errors = [
            sample.position - true_drive.position,
            (sample.velocity - true_drive.velocity) / 30.0,
            position.device + position.stretch - operator,
            (velocity.device + velocity.stretch - operator_velocity) / 30.0,
        ];
        let error = errors.iter().map(|error| error * error).sum::<f64>().sqrt();
        (1.0 / f64::from(steps), error)
    }))
}

#[test]
fn errors_fall_with_the_step_as_the_order_says() {
    let fine = [512, 1024, 2048, 4096];
    let coarse = [64, 128, 256, 512];
    for (slope, order) in [
        (order_of_one(SemiImplicitEuler, fine), 1.0),
        (order_of_one(ImplicitMidpoint, coarse), 2.0),
        (order_of_one(RungeKutta4, coarse), 4.0),
        (order_of_one(RungeKuttaNystrom4, coarse), 4.0),
        (order_of_two(SemiImplicitEuler, fine), 1.0),
        (order_of_two(ImplicitMidpoint, coarse), 2.0),
        (order_of_two(RungeKutta4, coarse), 4.0),
        (order_of_two(RungeKuttaNystrom4, coarse), 4.0),
        (order_of_one(DormandPrince5, [32, 64, 128, 256]), 5.0),
        (order_of_two(DormandPrince5, [64, 128, 256, 512]), 5.0),
        // Few enough steps that rounding stays out, and enough that the next order does.
        (order_of_one(DormandPrince8, [10, 12, 14, 16]), 8.0),
        (order_of_two(DormandPrince8, [16, 20, 24, 28]), 8.0),
    ] {
        assert_abs_diff_eq!(slope, order, epsilon = 0.1);
    }
}

#[test]
fn the_exact_motion_is_the_closed_form_to_rounding_in_any_number_of_steps() {
    for steps in [1, 2, 7, 100] {
        let dynamics = Oscillator::new(hand()).expect("parts");
        let mut plant = moved(dynamics, Exact::new(), PERIOD, steps).starting(START[0], START[1]);
        for n in 1..=10 {
            let sample = plant.advance(FORCE);
            let [x, v] = damped(hand(), START, FORCE, PERIOD * f64::from(n));
            // A few roundings of each step, of terms as large as the state: 0.03 m and 0.3 m/s.
            let roundings = 16.0 * U * f64::from(n) * f64::from(steps + 3);
            assert!(abs_diff_eq!(sample.position, x, epsilon = 0.03 * roundings), "{steps} {n}");
            assert!(abs_diff_eq!(sample.velocity, v, epsilon = 0.3 * roundings), "{steps} {n}");
        }
    }
}
