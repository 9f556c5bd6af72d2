//! Thirty digits against whole numbers of 128 bits.

use lyapunov_core::{DoubleDouble, Scalar, Signal};
use num_traits::{One, Zero};

use crate::Dice;

fn of(value: f64) -> DoubleDouble {
    DoubleDouble::of(value)
}

/// A whole number of up to 106 bits, in its two nearest parts.
fn whole(value: i128) -> DoubleDouble {
    let high = value as f64;
    DoubleDouble::from((high, (value - high as i128) as f64))
}

/// The whole number that a double-double is.
fn back(value: DoubleDouble) -> i128 {
    assert!(value.low().abs() <= value.high().abs() * 2f64.powi(-53), "{value:?} overlaps");
    value.high() as i128 + value.low() as i128
}

/// Off by less than `shares` of the epsilon, 2⁻¹⁰².
fn near(found: DoubleDouble, exact: i128, shares: i128) {
    let off = (back(found) - exact).abs();
    assert!(off <= (exact.abs() >> 102) * shares + 1, "{found:?} is off by {off} from {exact}");
}

fn long(dice: &mut Dice, bits: u32) -> i128 {
    (i128::from(dice.whole(53)) << (bits - 53)) + i128::from(dice.whole(bits - 53))
}

/// Sum and product of two `f64`: the nearest number, and exactly what it lacks.
#[test]
fn two_numbers_are_added_and_multiplied_without_error() {
    let mut dice = Dice(11);
    for _ in 0..3000 {
        let shift = dice.bits() % 60;
        let (a, b) = (i128::from(dice.whole(53)) << shift, i128::from(dice.whole(53)));
        for (found, exact) in [
            (DoubleDouble::sum_of(a as f64, b as f64), a + b),
            (DoubleDouble::product_of((a >> shift) as f64, b as f64), (a >> shift) * b),
        ] {
            assert_eq!(found.high(), exact as f64);
            assert_eq!(found.low(), (exact - exact as f64 as i128) as f64);
        }
    }
}

#[test]
fn long_numbers_keep_their_digits() {
    let mut dice = Dice(13);
    for _ in 0..3000 {
        let (a, b) = (long(&mut dice, 104), long(&mut dice, 100));
        near(whole(a) + whole(b), a + b, 1);
        near(whole(a) - whole(b), a - b, 1);
        // What fits is exact.
        let (c, d) = (long(&mut dice, 91), i128::from(dice.whole(50)));
        assert_eq!((back(whole(c) + whole(d)), back(whole(c) - whole(d))), (c + d, c - d));
        assert_eq!(back(whole(c >> 41) * whole(d)), (c >> 41) * d);
        // The nearest number of the sum comes first, but for what a rounding of the end may move.
        let (c, d) = (long(&mut dice, 63), long(&mut dice, 62));
        near(whole(c) * whole(d), c * d, 1);
        assert_eq!(back(-whole(a)), -a);
        let off = (whole(c) + whole(d)) * (whole(c) - whole(d))
            - (whole(c) * whole(c) - whole(d) * whole(d));
        let size = whole(c) * whole(c) + whole(d) * whole(d);
        assert!(!off.magnitude().above(size * DoubleDouble::epsilon() * of(4.0)), "{c} {d}");
        let (mut sum, mut rest, mut product) = (whole(c), whole(c), whole(c));
        sum += whole(d);
        rest -= whole(d);
        product *= whole(d);
        assert_eq!(
            (sum, rest, product),
            (whole(c) + whole(d), whole(c) - whole(d), whole(c) * whole(d))
        );
    }
    // Nearly all of it cancels: what is left is exact.
    let (a, b) = ((1i128 << 104) + 1, (1i128 << 104) - 1);
    assert_eq!((whole(a) - whole(b), whole(b) - whole(a)), (of(2.0), of(-2.0)));
    // Where the first parts cancel, the sum is that of the second ones, in two parts again.
    let (more, less) = (2f64.powi(-55), -2f64.powi(-115));
    let left = DoubleDouble::from((1.0, more)) + DoubleDouble::from((-1.0, less));
    assert_eq!(left, DoubleDouble::from((more, less)));
}

/// A quotient of whole numbers times 2^100, and a root of one times 2^100, against integer division and Newton's root.
#[test]
fn quotients_and_roots_keep_their_digits() {
    let mut dice = Dice(17);
    let scale = of(2f64.powi(60));
    for _ in 0..3000 {
        let (a, b) = (long(&mut dice, 63), i128::from(dice.whole(40) | 1));
        let quotient = (a << 60) / b;
        let found = whole(a) / whole(b) * scale;
        // The remainder is a part of one, and the quotient is rounded to 2⁻¹⁰² of itself.
        let found = found.rounded();
        let off = (back(found) - quotient).abs();
        assert!(off <= (quotient.abs() >> 101) + 1, "{a} / {b}: {found:?} is off by {off}");

        let square = long(&mut dice, 60).abs() + 1;
        let root = whole(square).sqrt() * of(2f64.powi(32));
        let rounded = back(root.rounded());
        // (root ± 1)² encloses the square times 2^64.
        let (least, most) = ((rounded - 1).pow(2), (rounded + 1).pow(2));
        let exact = square << 64;
        assert!(least < exact && exact < most, "√{square} is not {root:?} / 2^32");
        let root = whole(square).sqrt();
        let off = (root * root - whole(square)).magnitude();
        assert!(off.below(whole(square) * DoubleDouble::epsilon() * of(4.0)) || off.is_zero());
        assert_eq!(whole(square.min(1 << 50).pow(2)).sqrt(), whole(square.min(1 << 50)));
    }
}

/// Digits from tables of constants, to the thirtieth.
#[test]
fn constants_have_thirty_digits() {
    let decimal = |first: f64, rest: f64| of(first) / of(1e14) + of(rest) / of(1e14) / of(1e15);
    let close = |found: DoubleDouble, table: DoubleDouble| {
        let off = (found - table).magnitude();
        assert!(off.below(of(2e-29)), "{found:?} for {table:?}");
    };
    close(of(2.0).sqrt(), decimal(141421356237309.0, 504880168872420.0));
    close(of(10.0).sqrt(), decimal(316227766016837.0, 933199889354443.0));
    let (mut term, mut e) = (of(1.0), of(1.0));
    for n in 1..30 {
        term = term / of(f64::from(n));
        e += term;
    }
    close(e, decimal(271828182845904.0, 523536028747135.0));
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
    close(pi, decimal(314159265358979.0, 323846264338327.0));
}

/// As in `f64`: what is not finite has no second part.
#[test]
fn infinities_and_zeros_are_those_of_f64() {
    let (zero, one, huge) = (of(0.0), of(1.0), of(f64::INFINITY));
    let alike = |found: DoubleDouble, high: f64| {
        let same =
            found.high().to_bits() == high.to_bits() || found.high().is_nan() && high.is_nan();
        assert!(same && found.low() == 0.0, "{found:?} for {high}");
    };
    for a in [0.0, -0.0, 1.0, -3.0, f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
        for b in [0.0, -0.0, 1.0, -3.0, f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
            alike(of(a) * of(b), a * b);
            alike(of(a) + of(b), a + b);
            // A quotient of 0 has no sign.
            let quotient = of(a) / of(b);
            let same = quotient.high() == a / b || quotient.high().is_nan() && (a / b).is_nan();
            assert!(same, "{quotient:?} for {a} / {b}");
        }
        alike(-of(a), -a);
        if a == 0.0 || a == 1.0 || !(a.is_finite()) {
            alike(of(a).sqrt(), a.sqrt());
        }
        assert_eq!(of(a).finite(), a.is_finite());
    }
    for large in [of(f64::MAX) + of(f64::MAX), of(1e200) * of(1e200), of(1e200) / of(1e-200)] {
        alike(large, f64::INFINITY);
    }
    alike(DoubleDouble::sum_of(f64::MAX, f64::MAX), f64::INFINITY);
    alike(DoubleDouble::product_of(1e300, 1e300), f64::INFINITY);
    assert_eq!((one / huge, huge - one), (zero, huge));
    for nan in [zero / zero, huge - huge, huge * zero, of(-1.0).sqrt(), of(f64::NAN)] {
        assert!(
            nan.high().is_nan()
                && nan.low() == 0.0
                && !nan.below(one)
                && !nan.above(one)
                && nan != nan
        );
        assert_eq!((nan.larger(one), nan.smaller(one)), (one, one));
    }
    let largest = DoubleDouble::largest();
    assert!(largest.finite() && !(largest + largest).finite() && (largest - largest) == zero);
    assert_eq!((largest * one).high(), f64::MAX);
    // A splitting that leaves the range costs the second part, not the first.
    alike(of(1e305) * of(1.5), 1e305 * 1.5);
}

#[test]
fn parts_go_in_and_out() {
    let pair = DoubleDouble::from((1.0, 2f64.powi(-70)));
    assert_eq!((pair.high(), pair.low()), (1.0, 2f64.powi(-70)));
    assert_eq!(<(f64, f64)>::from(pair), (1.0, 2f64.powi(-70)));
    assert_eq!(DoubleDouble::from((1.0, 1.0)), of(2.0));
    assert!(DoubleDouble::from((-0.0, 0.0)).high().is_sign_negative());
    assert_eq!((f64::from(pair), DoubleDouble::from(3.0)), (1.0, of(3.0)));
    assert!(DoubleDouble::zero().is_zero() && !DoubleDouble::one().is_zero());
    assert_eq!((DoubleDouble::zero(), DoubleDouble::one()), (of(0.0), of(1.0)));
    assert_eq!((pair.lane(0), pair.lane(1).is_nan()), (1.0, true));
    assert_eq!((pair.real(0), pair.real(1).high().is_nan()), (pair, true));
    assert_eq!(DoubleDouble::from_reals(|_| pair), pair);
    assert_eq!((DoubleDouble::splat(pair), Signal::sum(pair)), (pair, pair));
    assert_eq!(pair.zip(of(2.0), |a, b| a + b), pair + of(2.0));
    assert_eq!(
        (Signal::choose(true, pair, of(0.0)), Signal::choose(false, pair, of(0.0))),
        (pair, of(0.0))
    );
    assert_eq!(DoubleDouble::epsilon(), of(2f64.powi(-102)));
    let largest = DoubleDouble::largest();
    assert_eq!((largest.high(), largest.low()), (f64::MAX, f64::MAX * 2f64.powi(-54)));
    assert_eq!(largest.high() + largest.low(), f64::MAX);
    assert_eq!(DoubleDouble::smallest_normal(), of(f64::MIN_POSITIVE));
    assert_eq!(DoubleDouble::smallest_positive(), of(5e-324));
}

#[test]
fn numbers_that_differ_in_the_second_part_are_told_apart() {
    let more = DoubleDouble::from((1.0, 2f64.powi(-80)));
    let one = of(1.0);
    assert!(one.below(more) && !more.below(one) && !one.below(one));
    assert!(
        one.below(of(2.0)) && !of(2.0).below(one) && !of(2.0).below(more) && more.below(of(2.0))
    );
    for (high, low, nearest) in [
        (0.5, 0.0, 1i128),
        (-0.5, 0.0, -1),
        (0.5, -1e-20, 0),
        (-0.5, 1e-20, 0),
        (0.5, 1e-20, 1),
        (2.5, -1e-17, 2),
        (-2.5, 0.0, -3),
        (-2.5, 1e-17, -2),
        (1.5, 1e-17, 2),
        (0.25, 0.0, 0),
        (-0.25, 0.0, 0),
        (2f64.powi(60), 0.5, (1 << 60) + 1),
        (2f64.powi(60), 0.25, 1 << 60),
        (2f64.powi(60), -0.5, 1 << 60),
        (-(2f64.powi(60)), 0.5, -(1 << 60)),
        (-(2f64.powi(60)), -0.5, -(1 << 60) - 1),
        (2f64.powi(60), 7.25, (1 << 60) + 7),
    ] {
        assert_eq!(back(DoubleDouble::from((high, low)).rounded()), nearest, "{high} + {low}");
    }
}
