//! Scalars and signals: comparison, choice, rounding and sums over axes.

use lyapunov_core::lanes::WideF64x4;
use lyapunov_core::{Mask, ParameterError, Requirement, Scalar, Signal};
use nalgebra::{SVector, Vector2, Vector3};

use crate::Dice;

/// On whole numbers a sum over axes is exact, whatever its order.
fn sums<const N: usize>(dice: &mut Dice) {
    let axes: SVector<f64, N> = SVector::from_fn(|_, _| dice.whole(30) as f64);
    let other: SVector<f64, N> = SVector::from_fn(|_, _| dice.whole(20) as f64);
    // Vectors have methods of their own with these names.
    assert_eq!(Signal::sum(axes), axes.iter().sum::<f64>());
    let products = axes.iter().zip(other.iter()).map(|(a, b)| a * b).sum::<f64>();
    assert_eq!(axes.inner(other), products);
    assert_eq!(Signal::sum(axes.times(other)), products);
    assert_eq!(Signal::scale(axes, 2.0), axes + axes);
}

#[test]
fn axes_add_up() {
    let mut dice = Dice(3);
    sums::<0>(&mut dice);
    sums::<1>(&mut dice);
    sums::<2>(&mut dice);
    sums::<3>(&mut dice);
    sums::<4>(&mut dice);
    sums::<5>(&mut dice);
    sums::<6>(&mut dice);
    sums::<7>(&mut dice);
    assert_eq!(Vector2::<f64>::splat(3.0), Vector2::new(3.0, 3.0));
    let (yes, no) = (Vector2::new(1.0, 2.0), Vector2::new(3.0, 4.0));
    assert_eq!((Signal::choose(true, yes, no), Signal::choose(false, yes, no)), (yes, no));
}

#[test]
fn a_signal_is_limited_and_known_to_be_finite() {
    let wild = Vector3::new(5.0, -5.0, f64::NAN);
    let tame = wild.limited(2.0);
    assert!(tame.x == 2.0 && tame.y == -2.0 && tame.z.is_nan());
    assert_eq!(Vector3::new(1.0, -1.0, 2.0).limited(2.0), Vector3::new(1.0, -1.0, 2.0));
    assert!(!wild.finite() && Vector3::new(f64::MAX, -f64::MAX, 0.0).finite());
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(!Signal::finite(Vector2::new(1.0, bad)) && !Signal::finite(bad));
    }
    assert!(Signal::finite(f64::MAX) && Signal::finite(f32::MIN_POSITIVE));
}

/// `f64::round`, `min` and `max` of the standard library are the other implementation.
fn compares<T: Scalar>(value: f64, other: f64) {
    let (a, b) = (T::of(value), T::of(other));
    let lanes = |it: T| (0..T::LANES).map(move |lane| it.lane(lane));
    assert!(lanes(a.rounded()).all(|it| it == value.round()), "{value}");
    assert!(lanes(a.magnitude()).all(|it| it.to_bits() == value.abs().to_bits()), "{value}");
    assert!(lanes(a.larger(b)).all(|it| it == value.max(other)));
    assert!(lanes(a.smaller(b)).all(|it| it == value.min(other)));
    let (below, above) = (a.below(b), a.above(b));
    assert_eq!((below.all(), below.any()), (value < other, value < other));
    assert_eq!((above.all(), above.any()), (value > other, value > other));
    assert_eq!(below.lane(0), value < other);
    assert!(!below.lane(T::LANES) && a.lane(T::LANES).is_nan());
    let chosen = T::choose(below, a, b);
    assert!(lanes(chosen).all(|it| it == value.min(other)));
}

#[test]
fn numbers_are_compared_chosen_and_rounded() {
    let mut dice = Dice(5);
    let halves = (0..500).map(|_| dice.whole(12) as f64 * 0.5).collect::<Vec<_>>();
    let large = [
        4503599627370495.5,
        4503599627370496.0,
        -4503599627370497.0,
        1e300,
        0.0,
        0.49999999999999994,
    ];
    for pair in halves.windows(2).chain(large.windows(2)) {
        compares::<f64>(pair[0], pair[1]);
        compares::<WideF64x4>(pair[0], pair[1]);
    }
    let not = f64::NAN;
    assert_eq!((Scalar::larger(not, 1.0), Scalar::smaller(not, 1.0)), (1.0, 1.0));
    assert!(!not.below(1.0) && !not.above(1.0));
}

#[test]
fn lanes_are_told_apart() {
    let lanes = WideF64x4::from_lanes(|lane| lane as f64);
    let above = lanes.above(WideF64x4::of(1.5));
    assert_eq!([0, 1, 2, 3, 4].map(|lane| above.lane(lane)), [false, false, true, true, false]);
    assert!(above.any() && !above.all() && !(above & !above).any() && (above | !above).all());
    assert_eq!((lanes.lane(2), lanes.lane(4).is_nan()), (2.0, true));
    assert!(
        <WideF64x4 as Scalar>::Mask::of(true).all()
            && !<WideF64x4 as Scalar>::Mask::of(false).any()
    );
}

/// The smallest, the largest and the step, by what comes before and after them.
#[test]
fn the_ends_of_the_range() {
    assert_eq!(<f64 as Scalar>::smallest_positive() / 2.0, 0.0);
    assert!(<f64 as Scalar>::smallest_normal().is_normal());
    assert!(!(<f64 as Scalar>::smallest_normal() / 2.0).is_normal());
    assert_eq!(<f64 as Scalar>::largest(), f64::MAX);
    assert_eq!(1.0 + <f64 as Scalar>::epsilon() / 2.0, 1.0);
    assert_eq!(<f64 as Scalar>::epsilon(), 2f64.powi(-52));
    assert_eq!((Scalar::sqrt(9.0), Scalar::sqrt(2.0f32)), (3.0, 2f32.sqrt()));
    assert_eq!((f64::of(0.1).real(0), 0.1f64.real(1).is_nan()), (0.1, true));
    assert_eq!(f32::from_reals(|_| 0.1), 0.1f32);
}

/// What each requirement lets through.
#[test]
fn requirements_hold_for_what_they_say() {
    use Requirement::*;
    let inf = f64::INFINITY;
    let numbers = [-inf, -1.0, 0.0, 1.0, 2.0, 3.0, inf, f64::NAN];
    for (requirement, fine) in [
        (Finite, [false, true, true, true, true, true, false, false]),
        (Positive, [false, false, false, true, true, true, false, false]),
        (NonNegative, [false, false, true, true, true, true, false, false]),
        (Limit, [false, false, true, true, true, true, true, false]),
        (AboveZero, [false, false, false, true, true, true, true, false]),
        (AtMost(2.0), [true, true, true, true, true, false, false, false]),
        (AtLeast(2.0), [false, false, false, false, true, true, false, false]),
        (InRange, [false, true, true, true, true, true, false, false]),
    ] {
        assert_eq!(numbers.map(|it| requirement.check("it", it).is_ok()), fine, "{requirement:?}");
        let narrow = numbers.map(|it| requirement.check("it", it as f32).is_ok());
        assert_eq!(narrow, fine, "{requirement:?} in f32");
        assert_eq!(requirement.check("it", 2.0), Ok(2.0));
    }
    assert!(AtMost(0.1).check("it", 0.1f32).is_err(), "which is above 0.1");
    assert!(Positive.check("it", f64::from_bits(1)).is_ok(), "the smallest number is above 0");
    assert!(NonNegative.check("it", -0.0).is_ok() && AtLeast(-inf).check("it", -inf).is_err());
    let refused = Positive.check_axes("axes", Vector3::new(1.0, -2.0, -3.0));
    assert_eq!(
        refused,
        Err(ParameterError { parameter: "axes", value: -2.0, requirement: Positive })
    );
    assert_eq!(Positive.check_axes("axes", Vector2::new(1.0, 2.0)), Ok(Vector2::new(1.0, 2.0)));
    let words = [Finite, Positive, NonNegative, Limit, AtMost(2.0), AtLeast(2.0), InRange]
        .map(|it| it.to_string());
    assert!(
        (0..7).all(|it| !words[it].is_empty() && !words[..it].contains(&words[it])),
        "{words:?}"
    );
    let told = refused.map_err(|it| it.to_string());
    assert_eq!(told, Err("axes is -2.0; it must be above 0 and finite".to_owned()));
}

/// Ties go away from zero; each axis by itself.
#[test]
fn a_count_is_the_nearest_multiple() {
    let counted = Vector3::new(0.8, -1.0, 1.2).counted(0.5);
    assert_eq!(counted, Vector3::new(1.0, -1.0, 1.0));
    assert_eq!([0.75_f64, -0.75, 0.2].map(|axis| axis.counted(0.5)), [1.0, -1.0, 0.0]);
}
