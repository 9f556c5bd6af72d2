//! Lanes against the scalar run, bit for bit, in every operation.

use proptest::array::uniform8;
use proptest::prelude::any;
use proptest::prop_assert;
use proptest::test_runner::TestCaseResult;

use lyapunov::lanes::{AutoF32x4, AutoF32x8, AutoF64x4, AutoF64x8, WideF32x8, WideF64x4};
use lyapunov::{Mask, Scalar, accumulators::Widen};

use crate::support::{Bits, CASES, Real, bad, hold, hostile, ordinary, same, wild};

/// Numbers of each kind, NaN and infinities among them.
fn number<T: Real>(bits: Bits) -> T {
    match bits >> 60 {
        0..=6 => hostile(bits << 4),
        7..=10 => wild(bits << 4),
        11 => bad(bits),
        12 => T::of((bits % 64) as f64 - 32.5),
        _ => ordinary(bits << 4, 8.0),
    }
}

/// Every operation on three numbers that gives a number.
fn numbers<T: Scalar>(a: T, b: T, c: T) -> Vec<T> {
    let mut assigned = [a, a, a];
    assigned[0] += b;
    assigned[1] -= b;
    assigned[2] *= b;
    let mut all = vec![
        a + b,
        a - b,
        a * b,
        a / b,
        -a,
        a.sqrt(),
        a.larger(b),
        a.smaller(b),
        a.magnitude(),
        a.rounded(),
        (a / b).rounded(),
        a.limited(b),
        a.limited(c.magnitude()),
        T::choose(a.below(b), b, c),
        T::choose(a.above(b) | b.below(c), a, c),
        T::choose(!(a.above(b) & c.finite()), a, c),
        a.times(b),
        a.scale(b),
        a.inner(b),
        a.sum(),
        a.map(|x| x * c),
        a.zip(b, |x, y| x - y),
        T::splat(a),
        T::of(0.1),
        T::zero(),
        T::one(),
        T::smallest_normal(),
        T::smallest_positive(),
        T::largest(),
        T::epsilon(),
    ];
    all.extend(assigned);
    all
}

/// Every comparison of three.
fn truths<T: Scalar>(a: T, b: T, c: T) -> Vec<T::Mask> {
    let (below, above) = (a.below(b), b.above(c));
    vec![
        below,
        above,
        a.finite(),
        (a * b).finite(),
        below & above,
        below | above,
        !below,
        T::Mask::of(true),
        T::Mask::of(false),
    ]
}

fn agree<L: Scalar, T: Real>(bits: &[[Bits; 8]; 3]) -> TestCaseResult {
    let [a, b, c] = bits.map(|bits| bits.map(number::<T>));
    let [x, y, z] = [a, b, c].map(|each| L::from_lanes(|lane| each[lane].f64()));
    let (found, decided) = (numbers(x, y, z), truths(x, y, z));
    for lane in 0..L::LANES {
        prop_assert!(same(x.lane(lane), a[lane].f64()), "in and out of lane {lane}");
        let exact = numbers(a[lane], b[lane], c[lane]);
        for (which, (found, exact)) in found.iter().zip(exact).enumerate() {
            let (found, exact) = (found.lane(lane), exact.f64());
            prop_assert!(
                same(found, exact),
                "operation {which}, lane {lane}: {found:e} for {exact:e}"
            );
        }
        let truth = truths(a[lane], b[lane], c[lane]);
        for (which, (decided, truth)) in decided.iter().zip(truth).enumerate() {
            prop_assert!(decided.lane(lane) == truth, "comparison {which}, lane {lane} is {truth}");
        }
    }
    for mask in decided {
        let lanes = || (0..L::LANES).map(|lane| mask.lane(lane));
        prop_assert!(mask.all() == lanes().all(|truth| truth));
        prop_assert!(mask.any() == lanes().any(|truth| truth));
        prop_assert!(!mask.lane(L::LANES) && x.lane(L::LANES).is_nan(), "lanes past the last");
    }
    Ok(())
}

fn operations<L: Scalar, T: Real>() {
    let of = || uniform8(any::<Bits>());
    hold(CASES, (of(), of(), of()), |(a, b, c)| agree::<L, T>(&[a, b, c]));
}

/// Widening loses nothing, narrowing rounds like the scalar.
fn widths<L: Widen>() {
    hold(CASES, (uniform8(any::<Bits>()), uniform8(any::<Bits>())), |(a, b)| {
        let (narrow, wide) = (a.map(number::<f32>), b.map(number::<f64>));
        let widened = L::from_lanes(|lane| narrow[lane].into()).widen();
        let narrowed = L::narrow(Scalar::from_lanes(|lane| wide[lane]));
        for lane in 0..L::LANES {
            prop_assert!(same(widened.lane(lane), narrow[lane].into()));
            prop_assert!(same(narrowed.lane(lane), f64::from(wide[lane] as f32)));
        }
        Ok(())
    });
}

macro_rules! lanes {
    ($($name:ident: $lanes:ident of $real:ident),+ $(,)?) => {$(
        #[test]
        fn $name() {
            operations::<$lanes, $real>();
        }
    )+};
}

lanes! {
    auto_f32x4: AutoF32x4 of f32,
    auto_f32x8: AutoF32x8 of f32,
    auto_f64x4: AutoF64x4 of f64,
    auto_f64x8: AutoF64x8 of f64,
    wide_f32x8: WideF32x8 of f32,
    wide_f64x4: WideF64x4 of f64,
}

#[test]
fn widening() {
    widths::<f32>();
    widths::<AutoF32x4>();
    widths::<AutoF32x8>();
}
