//! Signal: the value at a port, on one axis or several.

use core::fmt::Debug;
use core::ops::{Add, Sub};

use nalgebra::SVector;
use num_traits::Zero;

use crate::Scalar;

/// Effort, flow, position or displacement at a port: every [`Scalar`], nalgebra's `SVector<T, N>` of any scalar `T`, and
/// pairs of signals, such as a [`Screw`](crate::Screw).
///
/// ```
/// use lyapunov_core::Signal;
/// use nalgebra::Vector3;
/// let (force, velocity) = (Vector3::new(1.0, 2.0, 0.0), Vector3::new(0.5, 0.25, 9.0));
/// assert_eq!(force.inner(velocity), 1.0);
/// ```
pub trait Signal:
    Copy + Debug + PartialEq + Zero + Add<Output = Self> + Sub<Output = Self> + 'static
{
    /// The number type of each axis.
    type Scalar: Scalar;

    /// `value` on every axis.
    fn splat(value: Self::Scalar) -> Self;

    /// `f` of the two, axis by axis.
    fn zip(self, other: Self, f: impl FnMut(Self::Scalar, Self::Scalar) -> Self::Scalar) -> Self;

    /// The sum over the axes, in an order of the type's own: of a vector, the sum of the even ones plus the sum of the odd ones.
    fn sum(self) -> Self::Scalar;

    /// `yes` where `mask` is true, `no` elsewhere, on every axis. Both are evaluated.
    fn choose(mask: <Self::Scalar as Scalar>::Mask, yes: Self, no: Self) -> Self;

    /// `f` of each axis.
    #[inline(always)]
    fn map(self, mut f: impl FnMut(Self::Scalar) -> Self::Scalar) -> Self {
        self.zip(self, |axis, _| f(axis))
    }

    /// The products axis by axis: an effort times a displacement is the work on each axis, in joules.
    #[inline(always)]
    fn times(self, other: Self) -> Self {
        self.zip(other, |a, b| a * b)
    }

    /// Every axis times `factor`.
    #[inline(always)]
    fn scale(self, factor: Self::Scalar) -> Self {
        self.map(|axis| axis * factor)
    }

    /// The power product `Σ aᵢ bᵢ`: effort paired with flow, in watts.
    #[inline(always)]
    fn inner(self, other: Self) -> Self::Scalar {
        self.times(other).sum()
    }

    /// Every axis limited to `±limit`; a NaN stays one.
    #[inline(always)]
    fn limited(self, limit: Self::Scalar) -> Self {
        let choose = <Self::Scalar as Signal>::choose;
        self.map(|axis| {
            let below = choose(limit.below(axis), limit, axis);
            choose(axis.below(-limit), -limit, below)
        })
    }

    /// The nearest multiple of `step` on every axis, `round(x / step) step`, ties away from zero.
    #[inline(always)]
    fn counted(self, step: Self::Scalar) -> Self {
        self.map(|axis| (axis / step).rounded() * step)
    }

    /// Whether every axis is finite, lane by lane.
    #[inline(always)]
    fn finite(self) -> <Self::Scalar as Scalar>::Mask {
        // Zero times a finite number is zero; zero times anything else is NaN, which compares as not below.
        self.scale(Self::Scalar::zero()).sum().below(Self::Scalar::smallest_normal())
    }
}

impl<T: Scalar, const N: usize> Signal for SVector<T, N> {
    type Scalar = T;

    #[inline(always)]
    fn splat(value: T) -> Self {
        SVector::from([value; N])
    }

    #[inline(always)]
    fn zip(self, other: Self, f: impl FnMut(T, T) -> T) -> Self {
        self.zip_map(&other, f)
    }

    #[inline(always)]
    fn sum(self) -> T {
        // Two sums side by side, of even and odd axes, fit the processor's vectors; one running sum does not.
        let axes = self.data.0[0].as_slice();
        let (mut even, mut odd) = match axes {
            [] => return T::zero(),
            [only] => return *only,
            [first, second, ..] => (*first, *second),
        };
        for pair in 1..N.div_ceil(2) {
            even += axes[2 * pair];
            if 2 * pair + 1 < N {
                odd += axes[2 * pair + 1];
            }
        }
        even + odd
    }

    #[inline(always)]
    fn choose(mask: T::Mask, yes: Self, no: Self) -> Self {
        yes.zip_map(&no, |a, b| T::choose(mask, a, b))
    }
}

/// Functions of a signal that has one axis and is its own scalar.
#[doc(hidden)]
#[macro_export]
macro_rules! one_axis {
    (#[$inline:meta] $scalar:ty) => {
        #[$inline]
        fn splat(value: $scalar) -> Self {
            value
        }

        #[$inline]
        fn zip(self, other: Self, mut f: impl FnMut($scalar, $scalar) -> $scalar) -> Self {
            f(self, other)
        }

        #[$inline]
        fn sum(self) -> $scalar {
            self
        }
    };
}

/// Signal of a type with two parts that are signals of one scalar: part by part, with the sum over both unless another one stands
/// behind it.
#[doc(hidden)]
#[macro_export]
macro_rules! signal_of_parts {
    (
        $(#[$inline:meta])+
        impl[$($parameters:tt)*] $type:ty, in $scalar:ty, of $one:ident, $other:ident => $made:expr;
    ) => {
        $crate::signal_of_parts! {
            $(#[$inline])+
            impl[$($parameters)*] $type, in $scalar, of $one, $other => $made;
            $(#[$inline])+
            fn sum(self) -> $scalar {
                $crate::Signal::sum(self.$one) + $crate::Signal::sum(self.$other)
            }
        }
    };
    (
        $(#[$inline:meta])+
        impl[$($parameters:tt)*] $type:ty, in $scalar:ty, of $one:ident, $other:ident => $made:expr;
        $($own:item)+
    ) => {
        impl<$($parameters)*> core::ops::Add for $type {
            type Output = Self;

            $(#[$inline])+
            fn add(self, next: Self) -> Self {
                let ($one, $other) = (self.$one + next.$one, self.$other + next.$other);
                $made
            }
        }

        impl<$($parameters)*> core::ops::Sub for $type {
            type Output = Self;

            $(#[$inline])+
            fn sub(self, next: Self) -> Self {
                let ($one, $other) = (self.$one - next.$one, self.$other - next.$other);
                $made
            }
        }

        impl<$($parameters)*> num_traits::Zero for $type {
            $(#[$inline])+
            fn zero() -> Self {
                let ($one, $other) = (num_traits::Zero::zero(), num_traits::Zero::zero());
                $made
            }

            #[inline]
            fn is_zero(&self) -> bool {
                num_traits::Zero::is_zero(&self.$one) && num_traits::Zero::is_zero(&self.$other)
            }
        }

        impl<$($parameters)*> $crate::Signal for $type {
            type Scalar = $scalar;

            $(#[$inline])+
            fn splat(value: $scalar) -> Self {
                let ($one, $other) = ($crate::Signal::splat(value), $crate::Signal::splat(value));
                $made
            }

            $(#[$inline])+
            fn zip(self, next: Self, mut f: impl FnMut($scalar, $scalar) -> $scalar) -> Self {
                let $one = $crate::Signal::zip(self.$one, next.$one, &mut f);
                let $other = $crate::Signal::zip(self.$other, next.$other, f);
                $made
            }

            $(#[$inline])+
            fn choose(mask: <$scalar as $crate::Scalar>::Mask, yes: Self, no: Self) -> Self {
                let $one = $crate::Signal::choose(mask, yes.$one, no.$one);
                let $other = $crate::Signal::choose(mask, yes.$other, no.$other);
                $made
            }

            $($own)+
        }
    };
}
