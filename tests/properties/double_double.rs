//! Thirty digits against whole numbers, identities and published constants.

use approx::assert_relative_eq;
use lyapunov::{
    Plant, Scalar, Signal,
    accumulators::DoubleDouble,
    bodies::{Body, Impedance},
};
use proptest::prelude::any;
use proptest::prop_assert;

use crate::support::{CASES, hold};

fn of(value: f64) -> DoubleDouble {
    DoubleDouble::of(value)
}

/// A whole number of at most 105 bits; anything longer loses digits here.
fn whole(value: i128) -> DoubleDouble {
    let high = value as f64;
    DoubleDouble::sum_of(high, (value - high as i128) as f64)
}

fn back(value: DoubleDouble) -> i128 {
    value.high() as i128 + value.low() as i128
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

/// Sums, differences and products of whole numbers that fit are exact.
#[test]
fn whole_numbers_are_exact() {
    hold(CASES, (any::<i64>(), any::<i64>(), 0u32..40), |(a, b, shift)| {
        let (a, b) = (i128::from(a >> 13), i128::from(b >> 13));
        prop_assert!(back(whole(a) * whole(b)) == a * b);
        let (long, other) = (a << shift, (b << shift) + a);
        prop_assert!(back(whole(long) + whole(other)) == long + other);
        prop_assert!(back(whole(long) - whole(other)) == long - other);
        Ok(())
    });
}

/// A quotient times its divisor, a root times itself and `(a + b) (a − b) = a² − b²`, to the epsilon.
#[test]
fn operations_keep_to_the_epsilon() {
    let epsilon = DoubleDouble::epsilon();
    hold(CASES, (any::<[i64; 4]>(), -60i32..60), |([a, b, c, d], scale)| {
        let unit = |high: i64, low: i64| {
            let low = low as f64 * 2f64.powi(-63) * (high as f64).abs() * 2f64.powi(-53);
            DoubleDouble::sum_of(high as f64, low)
        };
        let (x, y) = (unit(a | 1, b), unit(c | 1, d) * of(2f64.powi(scale)));
        let off = |got: DoubleDouble, want: DoubleDouble| (got - want).magnitude();
        prop_assert!(off(x / y * y, x).below(epsilon * x.magnitude() * of(2.0)));
        let root = x.magnitude().sqrt();
        prop_assert!(off(root * root, x.magnitude()).below(epsilon * x.magnitude() * of(3.0)));
        let size = (x * x + y * y) * epsilon * of(4.0);
        prop_assert!(off((x + y) * (x - y), x * x - y * y).below(size));
        Ok(())
    });
}

/// Digits from tables of constants.
#[test]
fn constants_have_thirty_digits() {
    assert_relative_eq!(
        of(2.0).sqrt(),
        digits("1.414213562373095048801688724209"),
        max_relative = END
    );
    assert_relative_eq!(
        of(10.0).sqrt(),
        digits("3.162277660168379331998893544432"),
        max_relative = END
    );
    let mut term = of(1.0);
    let mut e = term;
    for n in 1..30 {
        term = term / of(f64::from(n));
        e += term;
    }
    assert_relative_eq!(e, digits("2.718281828459045235360287471352"), max_relative = END);
    // Machin: π = 16 atan(1/5) − 4 atan(1/239).
    let arctangent = |inverse: f64| {
        let terms = (0..25).map(|n| {
            let power = (0..=2 * n).fold(of(1.0), |power, _| power / of(inverse));
            let term = power / of(f64::from(2 * n + 1));
            if n % 2 == 0 { term } else { -term }
        });
        terms.fold(of(0.0), |sum, term| sum + term)
    };
    let pi = of(16.0) * arctangent(5.0) - of(4.0) * arctangent(239.0);
    assert_relative_eq!(pi, digits("3.141592653589793238462643383279"), max_relative = END);
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

#[test]
fn infinities_nan_and_zeros_are_those_of_f64() {
    let (zero, one, huge) = (of(0.0), of(1.0), of(f64::INFINITY));
    assert_eq!((one / zero).high(), f64::INFINITY);
    assert_eq!((-one / zero).high(), f64::NEG_INFINITY);
    assert_eq!((huge + one, huge * of(-2.0), one / huge), (huge, -huge, zero));
    assert_eq!((huge - one, huge + huge), (huge, huge));
    assert_eq!((huge.sqrt(), zero.sqrt()), (huge, zero));
    let not = [zero / zero, huge - huge, huge * zero, huge / huge, of(-1.0).sqrt(), of(f64::NAN)];
    for nan in not {
        assert!(nan.high().is_nan() && nan.low() == 0.0 && !nan.finite(), "{nan:?}");
        assert!(!nan.below(one) && !nan.above(one) && nan != nan);
        assert_eq!((nan.larger(one), nan.smaller(one)), (one, one));
        assert!((nan + one).high().is_nan() && (one * nan).high().is_nan());
    }
    let largest = DoubleDouble::largest();
    assert!(largest.finite() && !(largest + largest).finite() && (largest - largest) == zero);
    assert_eq!((largest * one).high(), f64::MAX);
    assert!((-zero).high().is_sign_negative() && (-zero + -zero).high().is_sign_negative());
    assert!((-zero * one).high().is_sign_negative());
    assert_eq!((one.lane(0), one.lane(1).is_nan(), one.real(1).high().is_nan()), (1.0, true, true));
}

#[test]
fn numbers_closer_than_f64_resolves_are_compared_and_rounded() {
    let one = of(1.0);
    let more = one + of(2f64.powi(-80));
    assert!(one.below(more) && more.above(one) && more != one && !more.below(one));
    for (high, low, want) in [
        (0.5, 0.0, 1),
        (-0.5, 0.0, -1),
        (0.5, -1e-20, 0),
        (-0.5, 1e-20, 0),
        (2.5, -1e-17, 2),
        (-2.5, 0.0, -3),
        (1.5, 1e-17, 2),
        (2f64.powi(60), 0.5, (1i128 << 60) + 1),
        (2f64.powi(60), -0.5, 1i128 << 60),
        (-(2f64.powi(60)), -0.5, -(1i128 << 60) - 1),
        (2f64.powi(60), 7.25, (1i128 << 60) + 7),
    ] {
        let rounded = DoubleDouble::sum_of(high, low).rounded();
        assert_eq!(back(rounded), want, "{high} + {low}");
    }
}
