//! Sums of what is finite.

use lyapunov_core::{Accumulator, Scalar};

/// Books `change` where the sum has room for it; returns where it did.
#[inline(always)]
pub(crate) fn book<T: Scalar>(sum: &mut impl Accumulator<T>, change: T) -> T::Mask {
    let booked = sum.fits(change);
    sum.add(T::choose(booked, change, T::of(0.0)));
    booked
}
