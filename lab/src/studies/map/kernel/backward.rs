//! Backward-difference velocity over a constant period.

use lyapunov::lanes::{AutoF32x16, AutoF64x8};
use lyapunov::{Mask, Scalar};

use crate::simulate::Aligned;

/// A scalar with fused multiplication and addition, in one rounding. A step of the loop must not use it, because its
/// bits would depend on the instructions; here it computes a quotient that is the same with and without it.
pub(super) trait Fuse: Scalar {
    /// Whether the processor multiplies and adds in one instruction, and that is faster than a division.
    const IS_FUSED: bool;

    /// `self factor + term`, rounded once.
    fn fused(self, factor: Self, term: Self) -> Self;
}

macro_rules! alone {
    ($($real:ident),+) => {$(
        impl Fuse for $real {
            const IS_FUSED: bool = false;

            #[inline(always)]
            fn fused(self, factor: Self, term: Self) -> Self {
                self.mul_add(factor, term)
            }
        }
    )+};
}

macro_rules! lanes {
    ($($lanes:ident),+) => {$(
        impl Fuse for Aligned<$lanes> {
            const IS_FUSED: bool = false;

            #[inline(always)]
            fn fused(self, factor: Self, term: Self) -> Self {
                let (value, factor, term) = (self.0.0, factor.0.0, term.0.0);
                let sum = |lane: usize| value[lane].mul_add(factor[lane], term[lane]);
                Self(std::array::from_fn(sum).into())
            }
        }
    )+};
}

alone!(f32, f64);
lanes!(AutoF64x8, AutoF32x16);

/// Period as a divisor.
#[derive(Clone, Copy, Debug)]
pub(super) struct Period<T> {
    period: T,
    inverse: T,
    /// The range of the magnitudes that are not divided.
    near: [T; 2],
    is_fused: bool,
}

impl<T: Fuse> Period<T> {
    /// `period` in all lanes, divided by in the way that is fastest for `T`.
    pub(super) fn of(period: f64) -> Self {
        Self::by(period, T::IS_FUSED)
    }

    fn by(period: f64, is_fused: bool) -> Self {
        // Farther out, an intermediate result may leave the range of the scalar.
        let is_fused = is_fused && (1e-9..1e9).contains(&period);
        let period = T::of(period);
        let near = [T::smallest_normal().sqrt(), T::largest().sqrt()];
        Self { period, inverse: T::one() / period, near, is_fused }
    }

    /// `moved / period`, correctly rounded.
    ///
    /// The product with the known inverse is within two units of the quotient, and its remainder, computed in one
    /// rounding, corrects it (Markstein, IBM Journal of Research and Development 34(1), 1990; Brisebarre, Muller and
    /// Raina, IEEE Transactions on Computers 53(8), 2004). Zeros keep their sign; numbers near the ends of the range are
    /// divided.
    #[inline(always)]
    pub(super) fn divide(&self, moved: T) -> T {
        if self.is_fused {
            let size = moved.magnitude();
            let near = size.above(self.near[0]) & size.below(self.near[1]);
            if (near | size.below(T::smallest_positive())).all() {
                return self.divide_near(moved);
            }
        }
        moved / self.period
    }

    /// [`divide`](Self::divide) for a `moved` that is 0 or far from the ends of the range.
    #[inline(always)]
    pub(super) fn divide_near(&self, moved: T) -> T {
        if !T::IS_FUSED {
            return moved / self.period;
        }
        let near = moved * self.inverse;
        let beyond = near.fused(self.period, -moved);
        (-beyond).fused(self.inverse, near)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn same(moved: f64, period: f64) {
        let quotient = Period::by(period, true).divide(moved);
        assert_eq!(quotient.to_bits(), (moved / period).to_bits(), "{moved:e} / {period:e}");
        let (moved, period) = (moved as f32, period as f32);
        let quotient = Period::<f32>::by(period.into(), true).divide(moved);
        assert_eq!(quotient.to_bits(), (moved / period).to_bits(), "{moved:e} / {period:e} in f32");
    }

    /// The inverse of an odd number among the integers modulo 2^64 (Newton).
    fn inverse(odd: u64) -> u64 {
        (0..6).fold(odd, |guess, _| guess.wrapping_mul(2_u64.wrapping_sub(odd.wrapping_mul(guess))))
    }

    /// Numbers whose quotient by `period` lies as near as possible to the middle between two numbers: with `t` the
    /// digits of the period, the `x` of `x 2^54 = m t + k` for odd `m` and small `k`.
    fn hardest(period: f64) -> Vec<f64> {
        const DIGITS: u64 = 1 << 52;
        let t = (period.to_bits() % DIGITS) | DIGITS;
        let (odd, twos) = (t >> t.trailing_zeros(), t.trailing_zeros());
        let small = (-40_i64..=40).filter(|k| *k != 0 && k.trailing_zeros() >= twos);
        let middles = small.flat_map(|k| {
            let first = (k >> twos).wrapping_neg() as u64;
            let first = first.wrapping_mul(inverse(odd)) % (1 << (54 - twos));
            let step = 1_u64 << (54 - twos);
            (0..4).map(move |turn| (first + turn * step, k))
        });
        let numbers = middles.map(|(m, k)| {
            let whole = (i128::from(m) * i128::from(t) + i128::from(k)) >> 54;
            whole as f64 * 2_f64.powi(-70)
        });
        numbers.collect()
    }

    #[test]
    fn quotients_next_to_the_middle_are_rounded_as_a_division_rounds() {
        let rates = [3.0, 7.0, 60.0, 100.0, 144.0, 999.0, 1e3, 1e3 + 1e-9, 4e3, 1e4, 44_100.0];
        let mut tried = 0;
        for period in rates.map(|rate: f64| rate.recip()) {
            for moved in hardest(period) {
                same(moved, period);
                same(-moved, period);
                tried += 1;
            }
        }
        assert!(tried > 1000, "{tried}");
    }

    #[test]
    fn zeros_keep_their_sign_and_the_ends_of_the_range_are_divided() {
        let ends = [0.0, f64::MIN_POSITIVE, 5e-324, 1e-160, 1e-154, 1e153, 1e155, 1e306, f64::MAX];
        for moved in ends.into_iter().chain([f64::INFINITY, 1e-19, 1e-23, 1e19, 1e38]) {
            for period in [1e-3, 1.0, 0.7, 1e-9, 5e8, 1e12, 1e-300] {
                same(moved, period);
                same(-moved, period);
            }
        }
        assert!(Period::by(1e-3, true).divide(f64::NAN).is_nan());
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(100_000))]

        #[test]
        fn any_quotient_is_that_of_a_division(
            moved in any::<f64>(),
            near in -1.0..1.0_f64,
            period in prop_oneof![1e-6..1.0_f64, (1_u32..100_000).prop_map(|rate| 1.0 / f64::from(rate))],
        ) {
            same(moved, period);
            same(near, period);
        }
    }
}
