//! One constraint on an input, at the ends of the range: what is feasible is met, and an input is finite.

use approx::assert_relative_eq;
use lyapunov::stabilizers::{Constraint, Input};
use nalgebra::Vector2;

fn told(input: Input<f64>) -> (f64, bool) {
    (input.input, input.feasible)
}

/// Where no finite input would do, the one that does not try is given, and said to be none.
#[test]
fn an_input_beyond_the_range_is_none() {
    let steep = Constraint { drift: 1e300, gain: 1e-160 };
    assert_eq!(told(steep.least_norm()), (0.0, false));
    assert_eq!(told(steep.filter(7.0, 1.0).expect("weights")), (7.0, false));
    assert_eq!(told(steep.sontag()), (0.0, false));
    // What nothing is asked of is met by whatever is wished.
    let met = Constraint { drift: -1.0, gain: 0.0 };
    assert_eq!(told(met.filter(7.0, 1.0).expect("weights")), (7.0, true));
    let idle = Constraint { drift: 1.0, gain: 0.0 };
    assert_eq!(told(idle.filter(7.0, 1.0).expect("weights")), (7.0, false));
}

/// Large numbers whose product is out of range are numbers.
#[test]
fn large_numbers_are_feasible() {
    let large: Constraint<f64> = Constraint { drift: 1e200, gain: 1e100 };
    let (input, feasible) = told(large.least_norm());
    assert!(feasible);
    assert_relative_eq!(input, -1e100, max_relative = 1e-14);
    let wide: Constraint<Vector2<f64>> =
        Constraint { drift: 1e200, gain: Vector2::new(3e99, 4e99) };
    let least = wide.least_norm();
    assert!(least.feasible);
    assert_relative_eq!(least.input, Vector2::new(-1.2e100, -1.6e100), max_relative = 1e-14);
    for unknown in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for (drift, gain) in [(unknown, 1.0), (-1.0, unknown)] {
            let constraint = Constraint { drift, gain };
            assert!(!told(constraint.least_norm()).1 && !told(constraint.sontag()).1);
        }
    }
}

/// An input that is not known meets nothing, whether the constraint asks for something or not.
#[test]
fn an_unknown_wish_is_not_feasible() {
    for wished in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for (drift, gain) in [(1.0, 2.0), (-1.0, 2.0), (-1.0, 0.0), (0.0, 1.0)] {
            let input = Constraint { drift, gain }.filter(wished, 1.0).expect("weights");
            assert!(!input.feasible, "{drift} + {gain} · {wished}: {}", input.input);
        }
    }
}

/// `u = w − max(0, a + b · w) R⁻¹ b / (b · R⁻¹ b)`, in whole numbers, and the name of what is refused.
#[test]
fn a_cheap_axis_is_changed_more() {
    let constraint = Constraint { drift: 4.0, gain: Vector2::new(2.0, 1.0) };
    // a + b · w = 9, R⁻¹ b = (1, 0.25), b · R⁻¹ b = 2.25.
    let input = constraint.filter(Vector2::new(1.0, 3.0), Vector2::new(2.0, 4.0)).expect("weights");
    assert_eq!((input.input, input.feasible), (Vector2::new(-3.0, 2.0), true));
    let kept = constraint.filter(Vector2::new(-3.0, 1.0), Vector2::new(2.0, 4.0)).expect("weights");
    assert_eq!((kept.input, kept.feasible), (Vector2::new(-3.0, 1.0), true));
    for bad in [0.0, -1.0, f64::INFINITY] {
        let refused = constraint.filter(Vector2::zeros(), Vector2::new(1.0, bad)).err();
        let refused = refused.map(|error| (error.parameter, error.value));
        assert_eq!(refused, Some(("input's weight", bad)));
    }
}
