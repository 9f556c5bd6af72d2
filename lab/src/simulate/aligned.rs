//! Lanes aligned to cache lines.

use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

use lyapunov::lanes::AutoF64x8;
use lyapunov::{Scalar, Signal, one_axis};
use num_traits::{One, Zero};

/// Lanes that fill exactly one line of the cache.
///
/// The lanes of [`lyapunov::lanes`] are aligned to 128 bits. Lanes across two lines are read and written twice, and
/// most of a step is reading and writing. Everything else is theirs.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(64))]
pub struct Aligned<T>(pub(crate) T);

/// Eight lanes of `f64`.
pub type F64x8 = Aligned<AutoF64x8>;

macro_rules! delegated {
    ($($operation:ident $method:ident),+ ; $($assigning:ident $assign:ident by $plain:ident),+) => {
        $(impl<T: Scalar> $operation for Aligned<T> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(other.0))
            }
        })+
        $(impl<T: Scalar> $assigning for Aligned<T> {
            #[inline(always)]
            fn $assign(&mut self, other: Self) {
                *self = self.$plain(other);
            }
        })+
    };
}

delegated!(Add add, Sub sub, Mul mul, Div div;
    AddAssign add_assign by add, SubAssign sub_assign by sub, MulAssign mul_assign by mul);

impl<T: Scalar> Neg for Aligned<T> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<T: Scalar> Zero for Aligned<T> {
    #[inline(always)]
    fn zero() -> Self {
        Self(T::zero())
    }

    #[inline(always)]
    fn is_zero(&self) -> bool {
        self.0.is_zero()
    }
}

impl<T: Scalar> One for Aligned<T> {
    #[inline(always)]
    fn one() -> Self {
        Self(T::one())
    }
}

impl<T: Scalar> Scalar for Aligned<T> {
    type Mask = T::Mask;

    type Real = T::Real;

    const LANES: usize = T::LANES;

    #[inline(always)]
    fn of(value: f64) -> Self {
        Self(T::of(value))
    }

    #[inline(always)]
    fn from_lanes(value: impl FnMut(usize) -> f64) -> Self {
        Self(T::from_lanes(value))
    }

    #[inline(always)]
    fn lane(self, index: usize) -> f64 {
        self.0.lane(index)
    }

    #[inline(always)]
    fn from_reals(value: impl FnMut(usize) -> T::Real) -> Self {
        Self(T::from_reals(value))
    }

    #[inline(always)]
    fn real(self, index: usize) -> T::Real {
        self.0.real(index)
    }

    #[inline(always)]
    fn smallest_normal() -> Self {
        Self(T::smallest_normal())
    }

    #[inline(always)]
    fn smallest_positive() -> Self {
        Self(T::smallest_positive())
    }

    #[inline(always)]
    fn largest() -> Self {
        Self(T::largest())
    }

    #[inline(always)]
    fn epsilon() -> Self {
        Self(T::epsilon())
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }

    #[inline(always)]
    fn below(self, other: Self) -> T::Mask {
        self.0.below(other.0)
    }
}

impl<T: Scalar> Signal for Aligned<T> {
    type Scalar = Self;

    one_axis!(
        #[inline(always)]
        Self
    );

    #[inline(always)]
    fn choose(mask: T::Mask, yes: Self, no: Self) -> Self {
        Self(T::choose(mask, yes.0, no.0))
    }

    // Written out, since the provided method passes a closure: the compiler does not inline one as long as this, and what is not
    // inlined is compiled without the caller's vector instructions.
    #[inline(always)]
    fn counted(self, step: Self) -> Self {
        (self / step).rounded() * step
    }
}
