//! Lanes: several rollouts in one number, with simba's lane types as [`Scalar`]s.
//!
//! The `Auto` types are arrays that the compiler vectorises; the `Wide` types use the processor's own vectors. Both
//! give each lane the bits of the scalar run.

use core::hint::black_box;

pub use simba::simd::{
    AutoF32x4, AutoF32x8, AutoF32x16, AutoF64x4, AutoF64x8, WideF32x8, WideF64x4,
};

use simba::simd::{
    AutoBoolx4, AutoBoolx8, AutoBoolx16, SimdBool, SimdComplexField, SimdPartialOrd, SimdValue,
    WideBoolF32x8, WideBoolF64x4,
};

use crate::one_axis;
use crate::{Mask, Scalar, Signal};

/// Mark in a loop over numbers of several lanes, which are vectors by themselves; for one lane it is nothing.
///
/// Without it the compiler may make vectors of one lane of neighbouring numbers, gathered and scattered, and take several times as
/// long. Such a loop is written out: folds and maps of arrays, and closures, are not always inlined, and a function that is called
/// computes lanes on the base set of instructions, whoever calls it.
///
/// ```
/// use lyapunov_core::{Scalar, lanes};
/// fn energy<T: Scalar>(stiffnesses: &[T; 64], depth: T) -> T {
///     let mut sum = T::zero();
///     for stiffness in stiffnesses {
///         lanes::apart::<T>();
///         sum += *stiffness * depth * depth;
///     }
///     sum * T::of(0.5)
/// }
/// assert_eq!(energy(&[2.0; 64], 0.5), 16.0);
/// ```
#[inline(always)]
pub fn apart<T: Scalar>() {
    if T::LANES > 1 {
        black_box(());
    }
}

/// The same value, whose lanes the compiler keeps together; for one lane it is nothing.
///
/// Later code may need the lanes one by one, as a choice between them does, and the compiler may then compute the value in pieces of
/// a few lanes too. A value that is written as a whole is computed as a whole.
#[inline(always)]
pub fn together<T: Scalar, V>(value: V) -> V {
    if T::LANES > 1 { black_box(value) } else { value }
}

macro_rules! mask {
    ($($mask:ty, $like:ty);+ $(;)?) => {$(
        impl Mask for $mask {
            #[inline(always)]
            fn of(truth: bool) -> Self {
                let one = <$like>::of(1.0);
                if truth { (-one).below(one) } else { one.below(one) }
            }

            #[inline(always)]
            fn lane(self, index: usize) -> bool {
                index < u64::BITS as usize && (self.bitmask() >> index) & 1 == 1
            }

            #[inline(always)]
            fn all(self) -> bool {
                SimdBool::all(self)
            }
        }
    )+};
}

macro_rules! lanes {
    ($($lanes:ident of $count:literal $real:ident, mask $mask:ty);+ $(;)?) => {$(
        impl Scalar for $lanes {
            type Mask = $mask;

            type Real = f64;

            const LANES: usize = $count;

            #[inline(always)]
            fn of(value: f64) -> Self {
                <$lanes as SimdValue>::splat(value as $real)
            }

            #[inline(always)]
            fn from_lanes(mut value: impl FnMut(usize) -> f64) -> Self {
                // Written out: a function of the library that fills arrays is not always inlined.
                let mut all = [0.0; $count];
                for (lane, number) in all.iter_mut().enumerate() {
                    *number = value(lane) as $real;
                }
                Self::from(all)
            }

            #[inline(always)]
            fn lane(self, index: usize) -> f64 {
                if index < $count { self.extract(index).into() } else { f64::NAN }
            }

            #[inline(always)]
            fn from_reals(value: impl FnMut(usize) -> f64) -> Self {
                Self::from_lanes(value)
            }

            #[inline(always)]
            fn real(self, index: usize) -> f64 {
                self.lane(index)
            }

            #[inline(always)]
            fn smallest_normal() -> Self {
                <$lanes as SimdValue>::splat($real::MIN_POSITIVE)
            }

            #[inline(always)]
            fn smallest_positive() -> Self {
                <$lanes as SimdValue>::splat($real::from_bits(1))
            }

            #[inline(always)]
            fn largest() -> Self {
                <$lanes as SimdValue>::splat($real::MAX)
            }

            #[inline(always)]
            fn epsilon() -> Self {
                <$lanes as SimdValue>::splat($real::EPSILON)
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                SimdComplexField::simd_sqrt(self)
            }

            #[inline(always)]
            fn below(self, other: Self) -> $mask {
                self.simd_lt(other)
            }
        }

        impl Signal for $lanes {
            type Scalar = $lanes;

            one_axis!(#[inline(always)] $lanes);

            #[inline(always)]
            fn choose(mask: $mask, yes: Self, no: Self) -> Self {
                yes.select(mask, no)
            }
        }
    )+};
}

mask! {
    AutoBoolx4, AutoF64x4;
    AutoBoolx8, AutoF64x8;
    AutoBoolx16, AutoF32x16;
    WideBoolF64x4, WideF64x4;
    WideBoolF32x8, WideF32x8;
}

lanes! {
    AutoF32x4 of 4 f32, mask AutoBoolx4;
    AutoF32x8 of 8 f32, mask AutoBoolx8;
    AutoF32x16 of 16 f32, mask AutoBoolx16;
    AutoF64x4 of 4 f64, mask AutoBoolx4;
    AutoF64x8 of 8 f64, mask AutoBoolx8;
    WideF64x4 of 4 f64, mask WideBoolF64x4;
    WideF32x8 of 8 f32, mask WideBoolF32x8;
}
