//! Lanes in the processor's own vectors, as [`Scalar`]s.
//!
//! A loop keeps them in registers. Lanes that are arrays stay in memory between two ticks, for the compiler finds the
//! vectors in them again only where it reads and writes memory.

use std::fmt;
use std::ops::{Add, AddAssign, BitAnd, BitOr, Div, Mul, MulAssign, Neg, Not, Sub, SubAssign};

use lyapunov::{Mask, Scalar, Signal, one_axis};
use num_traits::{One, Zero};
use pulp::NullaryFnOnce;
use pulp::bytemuck::{cast_slice, cast_slice_mut};

use super::backward::Fuse;
use super::batch::Batch;
use super::proven::Proven;

/// Does the same for the place of each of `N` vectors.
///
/// It is no loop, for a build for size keeps loops, and an array that is indexed in a loop stays in memory.
macro_rules! each {
    ($count:ident, $place:ident => $job:expr) => {
        const { assert!($count <= 4) };
        each!(@ $count, $place => $job, 0, 1, 2, 3);
    };
    (@ $count:ident, $place:ident => $job:expr, $($at:literal),+) => {
        $(if $at < $count {
            let $place = $at;
            $job;
        })+
    };
}

macro_rules! operators {
    ($lanes:ident: $($operation:ident $method:ident by $of_vector:ident),+ ;
        $($assigning:ident $assign:ident by $plain:ident),+) => {
        $(impl<S: Proven, const N: usize> $operation for $lanes<S, N> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.with(other, |proof, one, other| proof.$of_vector(one, other))
            }
        })+
        $(impl<S: Proven, const N: usize> $assigning for $lanes<S, N> {
            #[inline(always)]
            fn $assign(&mut self, other: Self) {
                *self = self.$plain(other);
            }
        })+
    };
}

macro_rules! logic {
    ($mask:ident: $($operation:ident $method:ident by $of_vector:ident),+) => {
        $(impl<S: Proven, const N: usize> $operation for $mask<S, N> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                let (mut vectors, proof) = (self.vectors, self.proof);
                each!(N, place => {
                    vectors[place] = proof.$of_vector(vectors[place], other.vectors[place])
                });
                Self { proof, vectors }
            }
        })+
    };
}

macro_rules! vectors {
    ($lanes:ident of $real:ident in $vector:ident, $mask:ident in $bits:ident,
        $splat:ident $add:ident $sub:ident $mul:ident $div:ident $keep:ident $flip:ident $sqrt:ident
        $smaller:ident $larger:ident $fused:ident, $less:ident $select:ident $first:ident
        $and:ident $or:ident $xor:ident) => {
        /// Lanes in `N` vectors of the instructions `S`.
        #[derive(Clone, Copy)]
        #[repr(align(64))]
        pub(super) struct $lanes<S: Proven, const N: usize> {
            proof: S,
            vectors: [S::$vector; N],
        }

        /// The outcome of a comparison, lane by lane.
        #[derive(Clone, Copy, Debug)]
        pub(super) struct $mask<S: Proven, const N: usize> {
            proof: S,
            vectors: [S::$bits; N],
        }

        impl<S: Proven, const N: usize> $lanes<S, N> {
            /// Lanes in one vector.
            const EACH: usize = size_of::<S::$vector>() / size_of::<$real>();

            #[inline(always)]
            fn all(value: $real) -> Self {
                let proof = S::here();
                Self { proof, vectors: [proof.$splat(value); N] }
            }

            #[inline(always)]
            fn with(
                self,
                other: Self,
                of: impl Fn(S, S::$vector, S::$vector) -> S::$vector,
            ) -> Self {
                let (mut vectors, proof) = (self.vectors, self.proof);
                each!(N, place => {
                    vectors[place] = of(proof, vectors[place], other.vectors[place])
                });
                Self { proof, vectors }
            }

            fn values(&self) -> &[$real] {
                cast_slice(&self.vectors)
            }
        }

        impl<S: Proven, const N: usize> fmt::Debug for $lanes<S, N> {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                self.values().fmt(f)
            }
        }

        impl<S: Proven, const N: usize> PartialEq for $lanes<S, N> {
            fn eq(&self, other: &Self) -> bool {
                self.values() == other.values()
            }
        }

        operators!($lanes: Add add by $add, Sub sub by $sub, Mul mul by $mul, Div div by $div;
            AddAssign add_assign by add, SubAssign sub_assign by sub, MulAssign mul_assign by mul);

        // By their bits: pulp's own sign and magnitude are not always inlined.
        impl<S: Proven, const N: usize> Neg for $lanes<S, N> {
            type Output = Self;

            #[inline(always)]
            fn neg(self) -> Self {
                self.with(Self::all(-0.0), |proof, one, sign| proof.$flip(one, sign))
            }
        }

        impl<S: Proven, const N: usize> Zero for $lanes<S, N> {
            #[inline(always)]
            fn zero() -> Self {
                Self::all(0.0)
            }

            fn is_zero(&self) -> bool {
                self.values().iter().all(|value| *value == 0.0)
            }
        }

        impl<S: Proven, const N: usize> One for $lanes<S, N> {
            #[inline(always)]
            fn one() -> Self {
                Self::all(1.0)
            }
        }

        impl<S: Proven, const N: usize> Signal for $lanes<S, N> {
            type Scalar = Self;

            one_axis!(#[inline(always)] Self);

            #[inline(always)]
            fn choose(mask: $mask<S, N>, yes: Self, no: Self) -> Self {
                let (mut vectors, proof) = (yes.vectors, yes.proof);
                each!(N, place => {
                    vectors[place] =
                        proof.$select(mask.vectors[place], vectors[place], no.vectors[place])
                });
                Self { proof, vectors }
            }
        }

        impl<S: Proven, const N: usize> Scalar for $lanes<S, N> {
            type Mask = $mask<S, N>;

            type Real = f64;

            const LANES: usize = N * Self::EACH;

            #[inline(always)]
            fn of(value: f64) -> Self {
                Self::all(value as $real)
            }

            fn from_lanes(mut value: impl FnMut(usize) -> f64) -> Self {
                let mut lanes = Self::all(0.0);
                let values: &mut [$real] = cast_slice_mut(&mut lanes.vectors);
                for (lane, place) in values.iter_mut().enumerate() {
                    *place = value(lane) as $real;
                }
                lanes
            }

            fn lane(self, index: usize) -> f64 {
                self.values().get(index).map_or(f64::NAN, |value| (*value).into())
            }

            fn from_reals(value: impl FnMut(usize) -> f64) -> Self {
                Self::from_lanes(value)
            }

            fn real(self, index: usize) -> f64 {
                self.lane(index)
            }

            #[inline(always)]
            fn smallest_normal() -> Self {
                Self::all($real::MIN_POSITIVE)
            }

            #[inline(always)]
            fn smallest_positive() -> Self {
                Self::all($real::from_bits(1))
            }

            #[inline(always)]
            fn largest() -> Self {
                Self::all($real::MAX)
            }

            #[inline(always)]
            fn epsilon() -> Self {
                Self::all($real::EPSILON)
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                self.with(self, |proof, one, _| proof.$sqrt(one))
            }

            #[inline(always)]
            fn below(self, other: Self) -> $mask<S, N> {
                let proof = self.proof;
                let mut vectors = [proof.$less(self.vectors[0], other.vectors[0]); N];
                each!(N, place => {
                    vectors[place] = proof.$less(self.vectors[place], other.vectors[place])
                });
                $mask { proof, vectors }
            }

            #[inline(always)]
            fn larger(self, other: Self) -> Self {
                self.with(other, |proof, one, other| proof.$larger(one, other))
            }

            #[inline(always)]
            fn smaller(self, other: Self) -> Self {
                self.with(other, |proof, one, other| proof.$smaller(one, other))
            }

            #[inline(always)]
            fn magnitude(self) -> Self {
                let unsigned = $real::from_bits(!$real::to_bits(-0.0));
                self.with(Self::all(unsigned), |proof, one, bits| proof.$keep(one, bits))
            }
        }

        impl<S: Proven, const N: usize> Fuse for $lanes<S, N> {
            const IS_FUSED: bool = S::FUSES;

            #[inline(always)]
            fn fused(self, factor: Self, term: Self) -> Self {
                let (mut vectors, proof) = (self.vectors, self.proof);
                each!(N, place => {
                    vectors[place] =
                        proof.$fused(vectors[place], factor.vectors[place], term.vectors[place])
                });
                Self { proof, vectors }
            }
        }

        impl<S: Proven, const N: usize> Batch for $lanes<S, N> {
            // More vectors in one group have enough to compute while one of them waits.
            const BESIDE: usize = if N == 2 { 2 } else { 1 };
            const IN_REGISTERS: bool = true;

            fn run<J: NullaryFnOnce>(job: J) -> J::Output {
                S::here().run(job)
            }
        }

        logic!($mask: BitAnd bitand by $and, BitOr bitor by $or);

        impl<S: Proven, const N: usize> Not for $mask<S, N> {
            type Output = Self;

            #[inline(always)]
            fn not(self) -> Self {
                let (mut vectors, proof) = (self.vectors, self.proof);
                let every = <Self as Mask>::of(true);
                each!(N, place => {
                    vectors[place] = proof.$xor(vectors[place], every.vectors[place])
                });
                Self { proof, vectors }
            }
        }

        impl<S: Proven, const N: usize> Mask for $mask<S, N> {
            #[inline(always)]
            fn of(truth: bool) -> Self {
                let proof = S::here();
                let (zero, one) = (proof.$splat(0.0), proof.$splat(1.0));
                let [small, large] = if truth { [zero, one] } else { [one, zero] };
                Self { proof, vectors: [proof.$less(small, large); N] }
            }

            fn lane(self, index: usize) -> bool {
                let (proof, each) = (self.proof, $lanes::<S, N>::EACH);
                let Some(vector) = self.vectors.get(index / each) else { return false };
                let truth = proof.$select(*vector, proof.$splat(1.0), proof.$splat(0.0));
                let values: &[$real] = cast_slice(std::slice::from_ref(&truth));
                values[index % each] == 1.0
            }

            #[inline(always)]
            fn all(self) -> bool {
                let untrue = !self;
                let mut any = untrue.vectors[0];
                each!(N, place => if place > 0 {
                    any = self.proof.$or(any, untrue.vectors[place])
                });
                self.proof.$first(any) == $lanes::<S, N>::EACH
            }
        }
    };
}

vectors! {
    F64s of f64 in f64s, F64Mask in m64s,
    splat_f64s add_f64s sub_f64s mul_f64s div_f64s and_f64s xor_f64s sqrt_f64s smaller_f64s larger_f64s mul_add_f64s,
    less_than_f64s select_f64s first_true_m64s and_m64s or_m64s xor_m64s
}

#[cfg(target_arch = "x86_64")]
vectors! {
    F32s of f32 in f32s, F32Mask in m32s,
    splat_f32s add_f32s sub_f32s mul_f32s div_f32s and_f32s xor_f32s sqrt_f32s smaller_f32s larger_f32s mul_add_f32s,
    less_than_f32s select_f32s first_true_m32s and_m32s or_m32s xor_m32s
}
