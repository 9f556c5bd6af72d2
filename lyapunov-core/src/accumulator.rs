//! Accumulators: running sums of energy, of which some keep their digits over a year of ticks.

use core::fmt::Debug;

use simba::simd::{AutoF32x4, AutoF32x8, AutoF64x4, AutoF64x8};

use crate::exact_sum::exact_sum;
use crate::{DoubleDouble, ParameterError, Requirement, Scalar, Snapshot};

/// A running sum of energies, J.
pub trait Accumulator<T: Scalar>: Copy + Debug {
    /// The empty sum.
    fn zero() -> Self;

    /// The sum of `energy` alone; the empty sum where that is not finite.
    fn holding(energy: T) -> Self {
        let mut sum = Self::zero();
        sum.book(energy);
        sum
    }

    /// Adds `term`.
    fn add(&mut self, term: T);

    /// Adds `term`, then raises a negative sum towards zero by at most `allowance`, which is not below 0; returns the sum
    /// before it was raised.
    fn add_and_raise(&mut self, term: T, allowance: T) -> T;

    /// Lowers a sum above `most` to `most`.
    fn lower(&mut self, most: T);

    /// Empties the sum; what it was made with stays.
    fn clear(&mut self) {
        *self = Self::zero();
    }

    /// The sum, rounded to the port's scalar.
    fn value(&self) -> T;

    /// `yes` where `mask` is true, `no` elsewhere, lane by lane.
    fn choose(mask: T::Mask, yes: Self, no: Self) -> Self;

    /// Adds `term` in the lanes whose sum stays finite; tells which.
    #[inline(always)]
    fn book(&mut self, term: T) -> T::Mask {
        // Added and looked at: at the end of the range a sum of several parts may have no room for what its value has.
        let mut sum = *self;
        sum.add(term);
        let booked = sum.value().finite();
        *self = Self::choose(booked, sum, *self);
        booked
    }
}

/// One number: fastest. In `f32` a sum of microjoules stops growing at 32 J.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plain<T> {
    sum: T,
}

impl<T: Scalar> Accumulator<T> for Plain<T> {
    #[inline(always)]
    fn zero() -> Self {
        Self { sum: T::zero() }
    }

    #[inline(always)]
    fn add(&mut self, term: T) {
        self.sum += term;
    }

    #[inline(always)]
    fn add_and_raise(&mut self, term: T, allowance: T) -> T {
        // An addition, a minimum and a maximum: the shortest chain from tick to tick, in the same time whatever the
        // data. The raised sum is computed beside the sum, not from it, at the price of one more rounding.
        let sum = self.sum + term;
        self.sum = (self.sum + (term + allowance)).smaller(T::zero()).larger(sum);
        sum
    }

    #[inline(always)]
    fn lower(&mut self, most: T) {
        self.sum = most.smaller(self.sum);
    }

    #[inline(always)]
    fn value(&self) -> T {
        self.sum
    }

    #[inline(always)]
    fn choose(mask: T::Mask, yes: Self, no: Self) -> Self {
        Self { sum: T::choose(mask, yes.sum, no.sum) }
    }
}

impl<T: Scalar> Snapshot for Plain<T> {
    type State = T;

    fn state(&self) -> T {
        self.sum
    }

    fn restored(self, sum: T) -> Result<Self, ParameterError> {
        Ok(Self { sum: Requirement::Finite.check("stored sum", sum)? })
    }
}

/// Two numbers of the port's own scalar: the sum and its accumulated rounding error, by the error-free sum
/// of two numbers (Knuth, The Art of Computer Programming, volume 2, section 4.2.2).
///
/// ```
/// use lyapunov_core::{Accumulator, Compensated, Plain};
/// let (mut plain, mut compensated) = (Plain::<f32>::zero(), Compensated::<f32>::zero());
/// plain.add(1.0);
/// compensated.add(1.0);
/// for _ in 0..1000 {
///     plain.add(1e-8); // lost beside 1 J
///     compensated.add(1e-8);
/// }
/// assert_eq!(plain.value(), 1.0);
/// assert!((f64::from(compensated.value()) - 1.00001).abs() < 1e-7);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Compensated<T> {
    sum: T,
    error: T,
}

impl<T: Scalar> Accumulator<T> for Compensated<T> {
    #[inline(always)]
    fn zero() -> Self {
        Self { sum: T::zero(), error: T::zero() }
    }

    #[inline(always)]
    fn add(&mut self, term: T) {
        let (sum, rounded) = exact_sum(self.sum, term);
        // The gathered error goes into the sum as soon as the sum can hold it. Errors that are only added up stop
        // growing, as any plain sum does; errors added with the next term are rounded off by it.
        (self.sum, self.error) = exact_sum(sum, rounded + self.error);
    }

    #[inline(always)]
    fn add_and_raise(&mut self, term: T, allowance: T) -> T {
        self.add(term);
        let value = self.value();
        let mut raised = *self;
        raised.add(allowance);
        let partly = value.below(-allowance);
        let owed = value.below(T::zero());
        *self = Self::choose(owed, Self::choose(partly, raised, Self::zero()), *self);
        value
    }

    #[inline(always)]
    fn lower(&mut self, most: T) {
        let above = self.value().above(most);
        *self = Self::choose(above, Self { sum: most, error: T::zero() }, *self);
    }

    #[inline(always)]
    fn value(&self) -> T {
        self.sum + self.error
    }

    #[inline(always)]
    fn choose(mask: T::Mask, yes: Self, no: Self) -> Self {
        Self { sum: T::choose(mask, yes.sum, no.sum), error: T::choose(mask, yes.error, no.error) }
    }
}

impl<T: Scalar> Snapshot for Compensated<T> {
    type State = (T, T);

    fn state(&self) -> (T, T) {
        (self.sum, self.error)
    }

    fn restored(self, (sum, error): (T, T)) -> Result<Self, ParameterError> {
        Requirement::Finite.check("stored sum", sum + error)?;
        Ok(Self { sum, error })
    }
}

/// A scalar that has a wider one.
pub trait Widen: Scalar {
    /// The wider scalar, with as many lanes.
    type Wide: Scalar<Mask = Self::Mask>;

    /// The same number, wider.
    fn widen(self) -> Self::Wide;

    /// The nearest number that fits.
    fn narrow(wide: Self::Wide) -> Self;
}

macro_rules! widen {
    ($($narrow:ty => $wide:ty),+ $(,)?) => {$(
        impl Widen for $narrow {
            type Wide = $wide;

            #[inline(always)]
            fn widen(self) -> $wide {
                Scalar::from_lanes(|lane| self.lane(lane))
            }

            #[inline(always)]
            fn narrow(wide: $wide) -> Self {
                Scalar::from_lanes(|lane| wide.lane(lane))
            }
        }
    )+};
}

widen!(f32 => f64, AutoF32x4 => AutoF64x4, AutoF32x8 => AutoF64x8, f64 => DoubleDouble);

/// One number wider than the port's: an `f64` sum under an `f32` port costs little and is as good as `f64`; under an
/// `f64` port the sum is a [`DoubleDouble`].
///
/// ```
/// use lyapunov_core::{Accumulator, Wide};
/// let mut sum = Wide::<f32>::zero(); // an `f64` inside
/// (0..1000).for_each(|_| sum.add(1e-3));
/// assert_eq!(sum.value(), 1.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wide<T: Widen> {
    sum: Plain<T::Wide>,
}

impl<T: Widen> Accumulator<T> for Wide<T> {
    #[inline(always)]
    fn zero() -> Self {
        Self { sum: Plain::zero() }
    }

    #[inline(always)]
    fn add(&mut self, term: T) {
        self.sum.add(term.widen());
    }

    #[inline(always)]
    fn add_and_raise(&mut self, term: T, allowance: T) -> T {
        T::narrow(self.sum.add_and_raise(term.widen(), allowance.widen()))
    }

    #[inline(always)]
    fn lower(&mut self, most: T) {
        self.sum.lower(most.widen());
    }

    #[inline(always)]
    fn value(&self) -> T {
        T::narrow(self.sum.value())
    }

    #[inline(always)]
    fn choose(mask: T::Mask, yes: Self, no: Self) -> Self {
        Self { sum: Accumulator::<T::Wide>::choose(mask, yes.sum, no.sum) }
    }
}

impl<T: Widen> Snapshot for Wide<T> {
    type State = T::Wide;

    fn state(&self) -> T::Wide {
        self.sum.state()
    }

    fn restored(self, sum: T::Wide) -> Result<Self, ParameterError> {
        Requirement::Finite.check("stored sum", T::narrow(sum))?;
        Ok(Self { sum: self.sum.restored(sum)? })
    }
}
