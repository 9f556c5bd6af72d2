//! Energy that each method keeps.

use approx::abs_diff_eq;
use lyapunov::{
    Plant, PortSample,
    bodies::{ElasticJoint, Impedance, TwoMassParts},
    integrators::{
        CoupledOscillators, Exact, ImplicitMidpoint, Integrator, Oscillator, RungeKuttaNystrom4,
        SemiImplicitEuler, State,
    },
};

use crate::{U, moved, pair};

/// The energy of an undamped oscillator with ω = 1 rad/s after each step, over that before the first.
fn energies(
    integrator: impl Integrator<f64, Oscillator<f64>>,
    turn: f64,
    steps: u32,
) -> impl Iterator<Item = f64> {
    let parts = Impedance { mass: 1.0, damping: 0.0, stiffness: 1.0 };
    let dynamics = Oscillator::new(parts).expect("parts");
    let mut plant = moved(dynamics, integrator, turn, 1).starting(0.6, 0.8);
    (0..steps).map(move |_| {
        let PortSample { position, velocity, .. } = plant.advance(0.0);
        position * position + velocity * velocity
    })
}

#[test]
fn symplectic_integrators_keep_the_energy_bounded_over_a_million_steps() {
    // Symplectic Euler keeps v² + ω² x² − h ω² x v, in which the last term is at most h ω / 2 of the others.
    let turn = 0.1;
    let most = (1.0 + turn / 2.0) / (1.0 - turn / 2.0);
    let (mut low, mut high) = (f64::INFINITY, 0.0_f64);
    for energy in energies(SemiImplicitEuler, turn, 1_000_000) {
        (low, high) = (low.min(energy), high.max(energy));
    }
    let rounding = 1e6 * 16.0 * U;
    assert!(high < most * (1.0 + rounding) && low > (1.0 - rounding) / most, "{low} {high}");
    // It does vary: x = v against x = −v.
    assert!(high - low > turn / 2.0, "{low} {high}");
    // The midpoint rule keeps the energy itself. A method that did not would lose h⁶ / 72 a step, as RK4 does.
    for energy in energies(ImplicitMidpoint, 0.5, 1_000_000) {
        assert!(abs_diff_eq!(energy, 1.0, epsilon = rounding), "{energy}");
    }
}

#[test]
fn rk4_loses_the_energy_that_its_stability_function_says() {
    let turn = 0.5_f64;
    let kept = 1.0 - turn.powi(6) / 72.0 + turn.powi(8) / 576.0;
    let last = energies(RungeKuttaNystrom4, turn, 1000).last().expect("a step");
    assert!(abs_diff_eq!(last / kept.powi(1000), 1.0, epsilon = 1000.0 * 32.0 * U), "{last}");
}

#[test]
fn the_midpoint_rule_never_gains_energy_at_a_thousand_radians_a_step() {
    for damping in [0.0, 1e-3, 1.0, 2.0, 1e3, 1e6] {
        let parts = Impedance { mass: 1.0, damping, stiffness: 1.0 };
        let dynamics = Oscillator::new(parts).expect("parts");
        let mut plant = moved(dynamics, ImplicitMidpoint, 1e3, 1).starting(0.6, 0.8);
        let mut before = 1.0;
        for _ in 0..100_000 {
            let PortSample { position, velocity, .. } = plant.advance(0.0);
            let energy = position * position + velocity * velocity;
            assert!(energy <= before * (1.0 + 16.0 * 1e3 * U), "{damping} {before} {energy}");
            before = energy;
        }
        // The energy is constant without a damper, and falls with one.
        assert!(if damping == 0.0 { before > 0.99 } else { before < 0.99 }, "{damping} {before}");
    }
    let dynamics = CoupledOscillators::new(TwoMassParts {
        link: ElasticJoint { stiffness: 1e7, damping: 0.0 },
        ..pair()
    });
    let mut plant = moved(dynamics.expect("parts"), ImplicitMidpoint, 0.1, 1).starting(0.01, 0.0);
    // All springs together hold no more than the operator's did at the start.
    for _ in 0..10_000 {
        let sample = plant.advance(0.0);
        let State { position, velocity } = plant.state();
        let operator = position.device + position.stretch;
        let stored = 25.0 * operator * operator + 0.1 * velocity.device * velocity.device;
        assert!(stored <= 25.0 * 0.01 * 0.01 * (1.0 + 1e-6), "{sample:?}");
    }
}

#[test]
fn in_f32_an_undamped_swing_keeps_its_size_within_the_rounding_of_its_steps() {
    let parts = Impedance { mass: 0.3_f32, damping: 0.0, stiffness: 50.0 };
    let steps = 100_000_u32;
    let dynamics = Oscillator::new(parts).expect("parts");
    let mut plant = moved(dynamics, ImplicitMidpoint, 1e-3, 1).starting(-0.004, 0.0);
    let mut exact = moved(dynamics, Exact::new(), 1e-3, 1).starting(-0.004, 0.0);
    let mut one_by_one = moved(dynamics, ImplicitMidpoint, 10.0, steps / 10).starting(-0.004, 0.0);
    let energy = |sample: PortSample<f32>| {
        let (x, v) = (f64::from(sample.position), f64::from(sample.velocity));
        0.5 * (50.0 * x * x + 0.3 * v * v)
    };
    let first = 0.5 * 50.0 * 0.004 * 0.004;
    // Both sums are rounded in each step, by half a unit at most, which moves the energy by twice that.
    let most = f64::from(steps) * 2.0 * f64::from(f32::EPSILON / 2.0);
    for tick in 1..=steps {
        let (midpoint, exact) = (plant.advance(0.0), exact.advance(0.0));
        assert!(abs_diff_eq!(energy(midpoint) / first, 1.0, epsilon = most), "{tick}");
        assert!(abs_diff_eq!(energy(exact) / first, 1.0, epsilon = most), "{tick}");
        if tick % (steps / 10) == 0 {
            // Its sums are rounded elsewhere.
            let apart = one_by_one.advance(0.0).position - midpoint.position;
            assert!(f64::from(apart.abs()) < 0.004 * most, "{tick}: {apart} m");
        }
    }
}
