//! Exact motion in thirty digits.

use approx::assert_relative_eq;
use lyapunov::{
    Plant, Scalar,
    accumulators::DoubleDouble,
    bodies::{Body, Impedance},
};

fn of(value: f64) -> DoubleDouble {
    DoubleDouble::of(value)
}

/// The error of the thirtieth digit.
const END: f64 = 1e-28;

/// The number with these digits, `digits / 10^30`, from two halves of fifteen digits.
fn digits(text: &str) -> DoubleDouble {
    let (point, text) = (text.find('.').expect("a point"), text.replace('.', ""));
    let (first, rest) = text.split_at(15);
    let number = |text: &str| of(text.parse::<f64>().expect("digits"));
    let ten = |power: usize| (0..power).fold(of(1.0), |product, _| product * of(10.0));
    number(first) / ten(15 - point) + number(&rest[..15]) / ten(30 - point)
}

/// The exact propagation of a swing of 1 rad/s over 1 s is the cosine and the sine of 1, to thirty digits.
#[test]
fn exact_motion_has_thirty_digits() {
    let swing = Impedance { mass: of(1.0), damping: of(0.0), stiffness: of(1.0) };
    let body = Body::new(swing, of(1.0)).expect("a body");
    let sample = body.starting(of(1.0), of(0.0)).advance(of(0.0));
    assert_relative_eq!(
        sample.position,
        digits("0.540302305868139717400936607442"),
        max_relative = END
    );
    assert_relative_eq!(
        -sample.velocity,
        digits("0.841470984807896506652502321630"),
        max_relative = END
    );
    // Critically damped: x = (1 + t) exp(−t), at t = 1.
    let creep = Impedance { damping: of(2.0), ..swing };
    let body = Body::new(creep, of(1.0)).expect("a body");
    let sample = body.starting(of(1.0), of(0.0)).advance(of(0.0));
    assert_relative_eq!(
        sample.position,
        digits("0.735758882342884643191047540322"),
        max_relative = END
    );
    assert_relative_eq!(
        -sample.velocity,
        digits("0.367879441171442321595523770161"),
        max_relative = END
    );
}

/// Beside the largest number a quotient is rounded as one of `f64` is.
#[test]
fn quotients_of_the_largest_numbers_are_finite() {
    for divisor in [1.0, 1.5, 3.0, 7.0, 1e10] {
        let quotient = of(f64::MAX) / of(divisor);
        assert_relative_eq!(quotient.lane(0), f64::MAX / divisor, max_relative = 1e-15);
    }
}
