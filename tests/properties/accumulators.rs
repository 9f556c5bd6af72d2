//! Sums of a million energies against exact ones in whole numbers.

use proptest::array::uniform4;
use proptest::collection::vec;
use proptest::prelude::any;
use proptest::prop_assert;
use proptest::test_runner::TestCaseResult;

use lyapunov::accumulators::{Accumulator, Compensated, Plain, Wide};

use crate::support::{Bits, CASES, Real, hold, unit};

const TERMS: usize = 1_000_000;

/// A term that is a whole number of `grain`s, of up to `digits` bits.
#[derive(Clone, Copy, Debug)]
struct Grains {
    digits: u32,
    grain: i32,
}

impl Grains {
    fn of<T: Real>() -> Self {
        if T::unit() < 1e-10 {
            Self { digits: 52, grain: -80 }
        } else {
            Self { digits: 23, grain: -40 }
        }
    }

    /// A signed number, of very different sizes, positive with the probability `drift`.
    fn number(self, bits: Bits, drift: f64) -> i128 {
        let size = (bits >> 11) >> (53 - self.digits) >> (bits % 13);
        let sign = if unit(bits.wrapping_mul(0x9e37_79b9_7f4a_7c15)) < drift { 1 } else { -1 };
        i128::from(size) * sign
    }

    fn joules(self, number: i128) -> f64 {
        number as f64 * 2f64.powi(self.grain)
    }

    fn term<T: Real>(self, number: i128) -> T {
        T::of(self.joules(number))
    }

    /// The exact number of grains in a scalar that is a whole number of them.
    fn count<T: Real>(self, value: T) -> i128 {
        (value.f64() * 2f64.powi(-self.grain)) as i128
    }
}

/// A generator of bits for long streams: Steele, Lea and Flood, OOPSLA 2014.
struct SplitMix(u64);

impl SplitMix {
    fn next(&mut self) -> Bits {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ self.0 >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ mixed >> 31
    }
}

/// The error of the sum is one rounding of itself, plus what the sum of the errors lost: one of its roundings per term.
/// The bound adds this up along an exact sum and the sum as the scalar rounds it.
fn compensated<T: Real>(seed: u64, drift: f64) {
    let (grains, mut bits) = (Grains::of::<T>(), SplitMix(seed));
    let (mut exact, mut rounded, mut lost) = (0i128, T::of(0.0), 0.0);
    let mut sum = Compensated::<T>::zero();
    for _ in 0..TERMS {
        let number = grains.number(bits.next(), drift);
        sum.add(grains.term(number));
        exact += number;
        rounded += grains.term::<T>(number);
        lost += T::unit() * grains.joules(exact - grains.count(rounded)).abs();
        let off = grains.joules(exact - grains.count(sum.value())).abs();
        let bound = T::unit() * grains.joules(exact).abs() + 1.01 * lost;
        assert!(off <= bound, "off by {off:e} of {:e}, {bound:e} allowed", grains.joules(exact));
    }
    let gained = grains.joules(exact - grains.count(rounded)).abs() / (lost + 1e-300);
    assert!(gained > 1.0, "a single number would be as good");
}

#[test]
fn compensated_f64() {
    for (seed, drift) in [(1, 0.5), (2, 0.45), (3, 1.0), (4, 0.0)] {
        compensated::<f64>(seed, drift);
    }
}

#[test]
fn compensated_f32() {
    for (seed, drift) in [(1, 0.5), (2, 0.45), (3, 1.0), (4, 0.0)] {
        compensated::<f32>(seed, drift);
    }
}

/// Every term and every sum here is a whole number of grains that an `f64` represents: the wide sum is exact, and its
/// value is the nearest `f32`.
#[test]
fn wide_is_exact() {
    for (seed, drift) in [(1, 0.5), (2, 0.45), (3, 1.0), (4, 0.0)] {
        let (grains, mut bits) = (Grains::of::<f32>(), SplitMix(seed));
        let (mut exact, mut sum) = (0i128, Wide::<f32>::zero());
        for _ in 0..TERMS {
            let number = grains.number(bits.next(), drift);
            sum.add(grains.term(number));
            exact += number;
            assert!(exact.unsigned_abs() < 1 << 53);
            assert_eq!(sum.value(), grains.joules(exact) as f32);
        }
    }
}

fn microjoules<A: Accumulator<f32>>(million: usize) -> f32 {
    let mut sum = A::zero();
    for _ in 0..million * TERMS {
        sum.add(1e-6);
    }
    sum.value()
}

/// A microjoule is less than half of the distance between `f32` numbers from 32 J on.
#[test]
fn plain_f32_stalls_at_32_joules() {
    assert_eq!(microjoules::<Plain<f32>>(40), 32.0);
    assert_eq!(microjoules::<Plain<f32>>(41), 32.0);
}

/// 70 million times the `f32` next to 1e-6, which is off by less than 3e-8 of it. The wide sum rounds each of the terms
/// by half a unit of an `f64` below 128.
#[test]
fn wide_f32_does_not_stall() {
    let exact = 70e6 * f64::from(1e-6f32);
    let off = (f64::from(microjoules::<Wide<f32>>(70)) - exact).abs();
    assert!(off <= f32::unit() * exact + 70e6 * f64::unit() * 64.0, "{off:e}");
}

/// Two numbers have twice the digits: 48 bits, of which the rounding of 70 million terms leaves 21.
#[test]
fn compensated_f32_does_not_stall() {
    let exact = 70e6 * f64::from(1e-6f32);
    let off = (f64::from(microjoules::<Compensated<f32>>(70)) - exact).abs();
    assert!(off <= 4.0 * f32::unit() * exact, "off by {off:e} of {exact:e}");
}

/// The energy of a spring that is pressed and released, up to half a joule in and out again: the remainder is small
/// beside the energy that flowed, and the sum has the digits of the remainder. Each step may lose a unit of the second
/// number, `u²` of the sum on the way; the reference, in `f64`, half a unit of its own.
#[test]
fn compensated_f32_keeps_what_flows_back_and_forth() {
    for seed in 1..4 {
        let (mut bits, mut sum) = (SplitMix(seed), Compensated::<f32>::zero());
        let (mut exact, mut stored) = (0f64, 0f64);
        for tick in 0..TERMS {
            let phase = (tick % 40) as f64 / 20.0;
            let next = 0.5 * phase.min(2.0 - phase) * unit(bits.next());
            let term = (next - stored) as f32;
            stored = next;
            sum.add(term);
            exact += f64::from(term);
            let lost = tick as f64 * (4.0 * f32::unit().powi(2) + f64::unit());
            let bound = 2.0 * f32::unit() * exact.abs() + lost;
            let off = (f64::from(sum.value()) - exact).abs();
            assert!(off <= bound, "off by {off:e} of {exact:e}, {bound:e} allowed, at {tick}");
        }
    }
}

/// Digits that a large energy pushes out of the sum come back when that energy leaves.
#[test]
fn compensated_gets_back_what_a_large_term_hides() {
    fn left<T: Real>(large: f64) -> f64 {
        let mut sum = Compensated::<T>::zero();
        for term in [1.0, large, -large] {
            sum.add(T::of(term));
        }
        sum.value().f64()
    }
    assert_eq!(left::<f32>(1e9), 1.0);
    assert_eq!(left::<f64>(1e17), 1.0);
}

/// Adding and then raising a debt towards zero, against whole numbers: the sum in between is the exact one, a debt is
/// raised by `most` or to zero, and a stored credit stays.
fn raises<T: Real, A: Accumulator<T>>(samples: &[[Bits; 4]]) -> TestCaseResult {
    let grains = Grains::of::<T>();
    let (mut exact, mut size, mut sum) = (0i128, 0i128, A::zero());
    for bits in samples {
        let number = grains.number(bits[0], 0.5);
        let most = match bits[1] % 4 {
            0 => 0,
            _ => grains.number(bits[2], 1.0),
        };
        let between = sum.add_and_raise(grains.term(number), grains.term(most));
        exact += number;
        // Each step rounds numbers no larger than these.
        size += exact.abs() + number.abs() + most.min(exact.abs());
        let bound = 4.0 * T::unit() * grains.joules(size);
        let off = (between.f64() - grains.joules(exact)).abs();
        prop_assert!(off <= bound, "between: {between:?} for {:e}", grains.joules(exact));
        if exact < 0 {
            exact = (exact + most).min(0);
        }
        let off = (sum.value().f64() - grains.joules(exact)).abs();
        prop_assert!(off <= bound, "raised: {:?} for {:e}", sum.value(), grains.joules(exact));
    }
    Ok(())
}

mod check {
    use super::*;

    pub(super) fn raises_debts<T: Real>() {
        hold(CASES, vec(uniform4(any::<Bits>()), 1..64), |samples| {
            raises::<T, Plain<T>>(&samples)?;
            raises::<T, Compensated<T>>(&samples)
        });
    }
}

crate::support::every_real!(raises_debts);

#[test]
fn wide_raises_debts() {
    hold(CASES, vec(uniform4(any::<Bits>()), 1..64), |samples| raises::<f32, Wide<f32>>(&samples));
}
