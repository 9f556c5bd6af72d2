//! Force bound: it keeps the account, and a larger one would not.

use approx::{abs_diff_eq, assert_abs_diff_eq};
use lyapunov::{
    HeldTick, PortSample, Stabilizer,
    stabilizers::{ForceBound, StabilizerExt},
};
use nalgebra::Vector3;

use crate::support::{Dice, PERIOD, held_tick};

const DAMPING: f64 = 0.2;
const BUDGET: f64 = 1e-3;

/// `E(n)` from outside: the budget, what crossed the port and what the device's damper burnt at least.
fn change(force: Vector3<f64>, moved: Vector3<f64>) -> f64 {
    force.dot(&moved) + DAMPING * moved.norm_squared() / PERIOD
}

/// The motion that takes the most out of the account under a held force.
fn worst(force: Vector3<f64>) -> Vector3<f64> {
    -force * PERIOD / (2.0 * DAMPING)
}

/// The least of the account over a run in which `factor` times the bounded force acts.
fn least(factor: f64, mut motion: impl FnMut(Vector3<f64>) -> Vector3<f64>) -> f64 {
    let mut bound = ForceBound::new(DAMPING).and_then(|it| it.budgeted(BUDGET)).expect("a bound");
    let mut dice = Dice::of(2);
    let mut sample = PortSample::starting(PERIOD, Vector3::zeros(), Vector3::zeros());
    let (mut energy, mut size, mut least) = (BUDGET, BUDGET, BUDGET);
    for _ in 0..2000 {
        let wanted: Vector3<f64> = dice.signal(1e4);
        let force = bound.stabilize(&sample, wanted).effort * factor;
        let moved = motion(force);
        energy += change(force, moved);
        // Two sums of the same, in another order.
        size += 2.0 * change(Vector3::zeros(), moved);
        least = least.min(energy + 16.0 * f64::EPSILON * size);
        sample = held_tick(Vector3::zeros(), moved, force);
    }
    least
}

#[test]
fn whatever_the_motion() {
    let mut dice = Dice::of(7);
    assert!(least(1.0, worst) >= 0.0);
    assert!(least(1.0, |force| worst(force) * 0.5) >= 0.0);
    assert!(least(1.0, |force| worst(force) * (1.0 + dice.within(0.5))) >= 0.0);
    assert!(least(1.0, |force| worst(force) + dice.signal::<Vector3<f64>>(1e-4)) >= 0.0);
}

/// `E − 1.05² E = −0.1025 E` after one tick of the worst motion.
#[test]
fn the_bound_is_tight() {
    assert!(least(1.05, worst) <= -0.1 * BUDGET);
    assert!(least(0.95, worst) >= 0.0);
}

#[test]
fn the_bound_is_the_closed_form() {
    for energy in [0.0, 1e-9, 1e-3, 4.0] {
        let bound = ForceBound::new(DAMPING).and_then(|it| it.budgeted(energy));
        let correction =
            bound.expect("a bound").stabilize(&PortSample::starting(PERIOD, 0.0, 0.0), -1e6);
        let closed = (4.0 * DAMPING * energy / PERIOD).sqrt();
        assert!(
            abs_diff_eq!(correction.effort, -closed, epsilon = 1e-13 * closed),
            "{}",
            correction.effort
        );
        let single = ForceBound::new(DAMPING as f32).and_then(|it| it.budgeted(energy as f32));
        let correction = single
            .expect("a bound")
            .stabilize(&PortSample::<f32>::starting(1e-3, 0.0, 0.0), -1e6_f32);
        assert_abs_diff_eq!(f64::from(correction.effort), -closed, epsilon = 1e-5 * closed);
    }
}

/// A device with that damper on a spring that a sample and hold makes active: the swing does not grow.
#[test]
fn a_held_spring_on_a_damped_mass_stays_bounded() {
    let swing = |bounded: bool| {
        let (mass, stiffness) = (0.2, 20_000.0);
        let start = 1e-3;
        let stored = 0.5 * stiffness * start * start;
        let mut bound = ForceBound::new(DAMPING).and_then(|it| it.budgeted(stored));
        let bound = bound.as_mut().expect("a bound");
        let (mut x, mut v, mut most) = (start, 0.0, 0f64);
        let mut sample = PortSample::starting(PERIOD, x, v);
        let decay = (-DAMPING * PERIOD / mass).exp();
        for _ in 0..3000 {
            let wanted = stiffness * x;
            let force = if bounded { bound.stabilize(&sample, wanted).effort } else { wanted };
            // m v' = −b v − F under a held F, in closed form.
            let rest = -force / DAMPING;
            let next = rest + (v - rest) * decay;
            let moved = rest * PERIOD + (v - rest) * (1.0 - decay) * mass / DAMPING;
            (x, v) = (x + moved, next);
            most = most.max(0.5 * mass * v * v);
            sample = held_tick(x, moved, force);
        }
        (most, stored)
    };
    let (free, stored) = swing(false);
    assert!(free > 100.0 * stored, "it is not active: {free:e}");
    let (bounded, stored) = swing(true);
    assert!(bounded <= stored * (1.0 + 1e-9), "{bounded:e} J from {stored:e} J");
}

/// Credit from a long free motion does not buy a burst.
#[test]
fn with_a_bounded_credit() {
    let bound = ForceBound::new(DAMPING).expect("a bound");
    let mut bound = bound.bounded(1e-4).expect("a bound");
    let free = HeldTick {
        period: PERIOD,
        position: 0.0,
        velocity: 0.5,
        displacement: 0.5 * PERIOD,
        applied: 0.0,
    }
    .sample();
    for _ in 0..1000 {
        bound.stabilize(&free, 0.0);
    }
    let force = bound.stabilize(&free, 1e6).effort;
    let energy = 1e-4 + DAMPING * 0.5 * 0.5 * PERIOD;
    assert_abs_diff_eq!(force, (4.0 * DAMPING * energy / PERIOD).sqrt(), epsilon = 1e-9);
}
