//! First-order equations, and mechanics as one of them.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use lyapunov::{
    Signal,
    integrators::{
        Adaptive, CoupledOscillators, DormandPrince5, DormandPrince8, Dynamics, Exact, Integrator,
        LinearDynamics, Oscillator, RungeKutta4, RungeKuttaNystrom4, State,
    },
    laws,
};
use nalgebra::Vector2;

use crate::{U, hand, pair};

/// `ẋ = (u − x) / τ` with τ of 0.1 s.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Lag;

const TAU: f64 = 0.1;

impl Dynamics<f64> for Lag {
    type State = f64;

    fn rate(&self, state: f64, input: f64) -> f64 {
        (input - state) / TAU
    }
}

impl LinearDynamics<f64> for Lag {
    type Increments = f64;

    fn increments(&self, interval: f64) -> f64 {
        -(-interval / TAU).exp_m1()
    }

    fn gain(increment: &f64, from: f64, input: f64) -> f64 {
        increment * (input - from)
    }
}

/// Prey and predator: two states that are not a position and its velocity.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Prey;

impl Dynamics<f64> for Prey {
    type State = Vector2<f64>;

    fn rate(&self, at: Vector2<f64>, hunted: f64) -> Vector2<f64> {
        Vector2::new(at.x * (1.0 - at.y - hunted), at.y * (at.x - 1.0 - hunted))
    }
}

#[test]
fn a_lag_follows_its_closed_form() {
    let truth = 0.3 + (1.0 - 0.3) * -(-0.05 / TAU).exp_m1();
    let after =
        |integrator: &mut dyn Integrator<f64, Lag>| 0.3 + integrator.step(&Lag, 0.3, 1.0, 0.05);
    assert_relative_eq!(after(&mut Exact::new()), truth, max_relative = 4.0 * U);
    // A method of order 8 has the terms up to the eighth, and part of the ninth, (h/τ)⁹ / 9!.
    let ninth = (1.0 - 0.3) * (0.05f64 / TAU).powi(9) / 362_880.0;
    assert_abs_diff_eq!(after(&mut DormandPrince8), truth, epsilon = ninth);
    let mut adaptive = Adaptive::new(DormandPrince5, 1e-12).expect("a tolerance");
    assert_abs_diff_eq!(after(&mut adaptive), truth, epsilon = 1e-10);
}

#[test]
fn integrators_of_any_equation_keep_their_laws_on_first_order_ones() {
    let starts = [(Vector2::new(1.5, 0.7), 0.1), (Vector2::new(0.4, 1.9), -0.2)];
    laws::integrator(&RungeKutta4, &Prey, starts, 1.0, 4).expect("of order 4");
    laws::integrator(&DormandPrince5, &Prey, starts, 1.0, 5).expect("of order 5");
    laws::integrator(&Exact::new(), &Lag, [(0.3, 1.0), (-2.0, 0.5)], 0.1, 100).expect("exact");
}

/// Nyström's form for masses and the textbook's differ only by rounding.
#[test]
fn nystroms_form_is_the_classical_method() {
    let one = Oscillator::new(hand()).expect("parts");
    let from = State { position: -0.004, velocity: 0.3 };
    let gain = RungeKutta4.step(&one, from, 1.5, 1e-3);
    let other = RungeKuttaNystrom4.step(&one, from, 1.5, 1e-3);
    assert_relative_eq!(gain, other, max_relative = 16.0 * U);

    let two = CoupledOscillators::<f64>::new(pair()).expect("parts");
    let from = State::splat(0.1);
    let gain = RungeKutta4.step(&two, from, 1.5, 1e-3);
    let other = RungeKuttaNystrom4.step(&two, from, 1.5, 1e-3);
    assert_relative_eq!(gain, other, max_relative = 64.0 * U);
}
