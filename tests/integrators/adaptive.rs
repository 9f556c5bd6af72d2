//! Step size by tolerance.

use core::cell::Cell;

use approx::{abs_diff_eq, assert_abs_diff_eq};
use lyapunov::{
    Plant, Requirement,
    bodies::Impedance,
    integrators::{
        Adaptive, CoupledOscillators, DormandPrince5, DormandPrince8, EmbeddedPair, Exact,
        Integrator, Mechanics, Oscillator, State,
    },
};
use nalgebra::Vector2;

use crate::{hand, moved, pair};

/// A pendulum that counts the evaluations of its acceleration.
struct Counted<'a>(&'a Cell<u32>);

impl Mechanics<f64> for Counted<'_> {
    type Coordinates = f64;

    fn acceleration(&self, angle: f64, rate: f64, effort: f64) -> f64 {
        self.0.set(self.0.get() + 1);
        -100.0 * angle.sin() - 0.1 * rate - effort
    }
}

fn adaptive<P>(pair: P, tolerance: f64) -> Adaptive<P, f64> {
    Adaptive::new(pair, tolerance).expect("a tolerance")
}

/// The end of two seconds of a pendulum, and the evaluations on the way.
fn swung(
    mut integrator: impl Integrator<f64, Counted<'static>>,
    counted: &'static Cell<u32>,
) -> (State<f64>, u32) {
    counted.set(0);
    let mut state = State { position: 2.0, velocity: 0.0 };
    for _ in 0..20 {
        state = state + integrator.step(&Counted(counted), state, 0.5, 0.1);
    }
    (state, counted.get())
}

#[test]
fn the_error_follows_the_tolerance_and_so_does_the_work() {
    let counted: &'static Cell<u32> = Box::leak(Box::new(Cell::new(0)));
    let (reference, _) = swung(adaptive(DormandPrince8, 2e-15), counted);
    let (other, _) = swung(adaptive(DormandPrince5, 2e-14), counted);
    let distance = |one: State<f64>, other: State<f64>| {
        (one.position - other.position).hypot(0.1 * (one.velocity - other.velocity))
    };
    // Two methods agree on it far better than any of the runs below.
    assert!(distance(reference, other) < 1e-11);
    let five = |tolerance| swung(adaptive(DormandPrince5, tolerance), counted);
    let eight = |tolerance| swung(adaptive(DormandPrince8, tolerance), counted);
    for tolerance in [1e-4, 1e-6, 1e-8, 1e-10] {
        for (end, work) in [five(tolerance), eight(tolerance)] {
            // Twenty intervals of a few steps each, whose errors a pendulum barely amplifies.
            let error = distance(end, reference);
            assert!(error < 100.0 * tolerance, "{error:e} at {tolerance:e}");
            assert!(error > 1e-6 * tolerance || tolerance < 1e-8, "{error:e} at {tolerance:e}");
            assert!(work < 20_000, "{work} at {tolerance:e}");
        }
    }
    // At order p a tolerance a thousand times finer costs about 1000^(1/p) times as much.
    let ratio = f64::from(five(1e-10).1) / f64::from(five(1e-7).1);
    assert!(ratio > 2.0 && ratio < 6.0, "{ratio}");
    let ratio = f64::from(eight(1e-12).1) / f64::from(eight(1e-9).1);
    assert!(ratio > 1.2 && ratio < 3.5, "{ratio}");
}

#[test]
fn steps_grow_again_after_a_stiff_motion() {
    let dynamics = Oscillator::new(hand::<f64>()).expect("parts");
    let stiff = Oscillator::new(Impedance { stiffness: 5e7, ..hand() }).expect("parts");
    let mut integrator = adaptive(DormandPrince5, 1e-9);
    let from = State { position: -0.004_f64, velocity: 0.05_f64 };
    integrator.step(&stiff, from, 0.0, 0.1);
    // Steps that were short for a stiff motion grow again, and the end is as accurate as with long ones.
    let after = integrator.step(&dynamics, from, 0.0, 0.1);
    let exact = Exact::new().step(&dynamics, from, 0.0, 0.1);
    assert_abs_diff_eq!(after.position, exact.position, epsilon = 1e-7);
    assert_abs_diff_eq!(after.velocity, exact.velocity, epsilon = 1e-7);
}

fn ends<P: EmbeddedPair<f64, Oscillator<f64>> + Copy>(pair: P) {
    let mut integrator = adaptive(pair, 1e-9);
    let dynamics = Oscillator::new(hand::<f64>()).expect("parts");
    let nan = |gain: State<f64>| gain.position.is_nan() && gain.velocity.is_nan();
    let at = |position, velocity| State { position, velocity };
    let sound = at(0.1, 0.1);
    for from in
        [at(f64::NAN, 0.0), at(0.0, f64::NAN), at(f64::INFINITY, 0.0), at(0.0, f64::NEG_INFINITY)]
    {
        assert!(nan(integrator.step(&dynamics, from, 0.0, 0.1)));
    }
    for effort in [f64::NAN, f64::INFINITY] {
        assert!(nan(integrator.step(&dynamics, sound, effort, 0.1)));
    }
    // Values so large that stages leave the range, or so stiff that no number of steps is enough.
    integrator.step(&dynamics, at(1e308, 1e308), 0.0, 1e3);
    let stiff = Oscillator::new(Impedance { stiffness: 1e25, ..hand() }).expect("parts");
    assert!(nan(integrator.step(&stiff, sound, 0.0, 0.1)));
    // From a sound state it continues unaffected.
    let gain = integrator.step(&dynamics, sound, 0.0, 0.1);
    let exact = Exact::new().step(&dynamics, sound, 0.0, 0.1);
    assert!(abs_diff_eq!(gain.position, exact.position, epsilon = 1e-7), "{gain:?} {exact:?}");
    let nothing = at(0.0, 0.0);
    assert_eq!(integrator.step(&dynamics, sound, 1.0, 0.0), nothing);
}

#[test]
fn every_step_ends() {
    ends(DormandPrince5);
    ends(DormandPrince8);
}

#[test]
fn a_tolerance_that_rounding_would_hide_is_refused() {
    let refused = |tolerance: f64| {
        let error = Adaptive::new(DormandPrince5, tolerance).expect_err("no tolerance");
        (error.parameter, error.requirement)
    };
    let least = ("tolerance", Requirement::AtLeast(8.0 * f64::EPSILON));
    for tolerance in [0.0, -1.0, 1e-16, f64::NAN, f64::INFINITY] {
        assert_eq!(refused(tolerance), least, "{tolerance}");
    }
    let error = Adaptive::new(DormandPrince8, 1e-9_f32).expect_err("no tolerance");
    assert_eq!(error.requirement, Requirement::AtLeast(8.0 * f64::from(f32::EPSILON)));
    assert!(Adaptive::new(DormandPrince8, 1e-6_f32).is_ok());
    // The finest allowed tolerance can be met, in either scalar, at a size of one and above.
    for size in [1e-3_f32, 1.0, 1e3] {
        let dynamics = Oscillator::new(hand::<f32>()).expect("parts");
        let finest = Adaptive::new(DormandPrince5, 8.0 * f32::EPSILON).expect("a tolerance");
        let mut plant = moved::<f32, _, _>(dynamics, finest, 0.1, 1).starting(size, 0.0);
        let mut exact = moved::<f32, _, _>(dynamics, Exact::new(), 0.1, 1).starting(size, 0.0);
        for _ in 0..10 {
            let (one, other) = (plant.advance(0.0), exact.advance(0.0));
            let error = (one.position - other.position).abs();
            assert!(error < 1e-4 * size.max(1.0), "{error:e} of {size:e} m");
        }
    }
}

#[test]
fn axes_and_masses_move_together() {
    let tolerance = 1e-10;
    let dynamics = Oscillator::new(hand::<f64>()).expect("parts");
    let start = (Vector2::new(-0.004, 0.3), Vector2::new(0.05, -2.0));
    let (mut plant, mut exact) = (
        moved::<Vector2<f64>, _, _>(dynamics, adaptive(DormandPrince8, tolerance), 0.2, 1),
        moved::<Vector2<f64>, _, _>(dynamics, Exact::new(), 0.2, 1),
    );
    (plant, exact) = (plant.starting(start.0, start.1), exact.starting(start.0, start.1));
    let coupled = CoupledOscillators::new(pair::<f64>()).expect("parts");
    let mut two = moved::<f64, _, _>(coupled, adaptive(DormandPrince5, tolerance), 0.2, 1)
        .starting(-0.004_f64, 0.1);
    let mut exactly = moved::<f64, _, _>(coupled, Exact::new(), 0.2, 1).starting(-0.004_f64, 0.1);
    for _ in 0..10 {
        let effort = Vector2::new(1.0, -0.5);
        let (one, other) = (plant.advance(effort), exact.advance(effort));
        assert!((one.position - other.position).norm() < 1e-8);
        let (one, other) = (two.advance(0.3), exactly.advance(0.3));
        assert_abs_diff_eq!(one.position, other.position, epsilon = 1e-8);
    }
}
