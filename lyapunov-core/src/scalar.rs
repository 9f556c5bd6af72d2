//! Scalar: the number type of a port, one real value or several lanes of them.

use core::fmt::Debug;
use core::ops::{AddAssign, BitAnd, BitOr, Div, Mul, MulAssign, Neg, Not, SubAssign};

use num_traits::One;

use crate::Signal;
use crate::one_axis;

/// Outcome of comparing two [`Scalar`]s: `bool` for one value, a lane mask for several.
///
/// ```
/// use lyapunov_core::{Mask, Scalar};
/// let faster = 0.2_f64.above(0.1);
/// assert!(faster.all() && !faster.lane(1));
/// ```
pub trait Mask:
    Copy + Debug + BitAnd<Output = Self> + BitOr<Output = Self> + Not<Output = Self>
{
    /// The same truth in every lane.
    fn of(truth: bool) -> Self;

    /// The truth of lane `index`; lanes past the last one are false.
    fn lane(self, index: usize) -> bool;

    /// Whether every lane is true.
    fn all(self) -> bool;

    /// Whether at least one lane is true.
    #[inline(always)]
    fn any(self) -> bool {
        !(!self).all()
    }
}

/// Real arithmetic that a step may use: `f32`, `f64`, lanes of either, or [`DoubleDouble`](crate::DoubleDouble).
///
/// Everything here is made of correctly rounded IEEE 754 operations, comparisons and choices, so a lane equals the
/// scalar run bit for bit. Fused multiply-add, the library minimum and maximum and transcendental functions are left
/// out because they break that equality. They belong to construction, which works lane by lane in `f64` through
/// [`lane`](Self::lane) and [`from_lanes`](Self::from_lanes), or, where arithmetic is enough, in the scalar's
/// [`Real`](Self::Real).
///
/// ```
/// use lyapunov_core::Scalar;
/// fn kinetic<T: Scalar>(mass: T, velocity: T) -> T {
///     T::of(0.5) * mass * velocity * velocity
/// }
/// assert_eq!(kinetic(2.0_f32, 3.0), 9.0);
/// ```
pub trait Scalar:
    Signal<Scalar = Self>
    + One
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
{
    /// The outcome of a comparison.
    type Mask: Mask;

    /// The number of construction, for one lane: an `f64`, or the scalar itself where that has more digits.
    type Real: Scalar<Mask = bool, Real = Self::Real>;

    /// The number of lanes.
    const LANES: usize;

    /// `value` in every lane, rounded to the element type.
    #[inline(always)]
    fn of(value: f64) -> Self {
        Self::from_lanes(|_| value)
    }

    /// The scalar whose lane `i` is `value(i)`, rounded to the element type.
    fn from_lanes(value: impl FnMut(usize) -> f64) -> Self;

    /// Lane `index` as an `f64`; lanes past the last one are NaN.
    fn lane(self, index: usize) -> f64;

    /// The scalar whose lane `i` is `value(i)`, rounded to the element type.
    fn from_reals(value: impl FnMut(usize) -> Self::Real) -> Self;

    /// Lane `index` with all its digits; lanes past the last one are NaN.
    fn real(self, index: usize) -> Self::Real;

    /// The smallest positive normal number: the smallest `v² T` that a stabilizer divides by.
    fn smallest_normal() -> Self;

    /// The smallest positive number.
    fn smallest_positive() -> Self;

    /// The largest finite number.
    fn largest() -> Self;

    /// The distance from one to the next larger number.
    fn epsilon() -> Self;

    /// The square root, correctly rounded.
    fn sqrt(self) -> Self;

    /// Whether `self < other`, lane by lane; false where either is NaN.
    fn below(self, other: Self) -> Self::Mask;

    /// Whether `self > other`, lane by lane; false where either is NaN.
    #[inline(always)]
    fn above(self, other: Self) -> Self::Mask {
        other.below(self)
    }

    /// `self` where it is larger than `other`, else `other`: a NaN in `self` gives `other`.
    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        Self::choose(self.above(other), self, other)
    }

    /// `self` where it is smaller than `other`, else `other`: a NaN in `self` gives `other`.
    #[inline(always)]
    fn smaller(self, other: Self) -> Self {
        Self::choose(self.below(other), self, other)
    }

    /// The magnitude.
    #[inline(always)]
    fn magnitude(self) -> Self {
        Self::choose(self.above(Self::zero()), self, Self::zero() - self)
    }

    /// The nearest whole number, ties away from zero.
    #[inline(always)]
    fn rounded(self) -> Self {
        // From 1 / epsilon on every number is whole, so adding it rounds, ties to even.
        let whole = Self::one() / Self::epsilon();
        let size = self.magnitude();
        let even = (size + whole) - whole;
        let not_tied_down = (size - even).below(Self::of(0.5));
        let nearest = Self::choose(not_tied_down, even, even + Self::one());
        let nearest = Self::choose(size.below(whole), nearest, size);
        Self::choose(self.below(Self::zero()), -nearest, nearest)
    }
}

/// Whether two masks are the same in every lane.
pub(crate) fn same_lanes<T: Scalar>(one: T::Mask, other: T::Mask) -> bool {
    (0..T::LANES).all(|lane| one.lane(lane) == other.lane(lane))
}

impl Mask for bool {
    #[inline(always)]
    fn of(truth: bool) -> Self {
        truth
    }

    #[inline(always)]
    fn lane(self, index: usize) -> bool {
        self && index == 0
    }

    #[inline(always)]
    fn all(self) -> bool {
        self
    }
}

macro_rules! real {
    ($real:ident) => {
        impl Scalar for $real {
            type Mask = bool;

            type Real = f64;

            const LANES: usize = 1;

            #[inline(always)]
            fn from_lanes(mut value: impl FnMut(usize) -> f64) -> Self {
                value(0) as $real
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
            fn lane(self, index: usize) -> f64 {
                if index == 0 { self.into() } else { f64::NAN }
            }

            #[inline(always)]
            fn smallest_normal() -> Self {
                $real::MIN_POSITIVE
            }

            #[inline(always)]
            fn smallest_positive() -> Self {
                $real::from_bits(1)
            }

            #[inline(always)]
            fn largest() -> Self {
                $real::MAX
            }

            #[inline(always)]
            fn epsilon() -> Self {
                $real::EPSILON
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                num_traits::Float::sqrt(self)
            }

            #[inline(always)]
            fn below(self, other: Self) -> bool {
                self < other
            }
        }

        impl Signal for $real {
            type Scalar = $real;

            one_axis!(
                #[inline(always)]
                $real
            );

            #[inline(always)]
            fn choose(mask: bool, yes: Self, no: Self) -> Self {
                if mask { yes } else { no }
            }

            #[inline(always)]
            fn finite(self) -> bool {
                // A test of the bits, which runs in processor units that a step leaves idle.
                self.is_finite()
            }
        }
    };
}

real!(f32);
real!(f64);
