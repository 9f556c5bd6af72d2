//! The damping that a force bound relies on.

use lyapunov_core::{ParameterError, Requirement, Scalar, Signal};
use nalgebra::{SMatrix, SVector};

use crate::factors::Factors;

/// A viscous damping `D` that the device surely has.
pub trait DeviceDamping<V: Signal>: sealed::Sealed {
    /// Least energy that it dissipates over a displacement, `Δxᵀ (D / T) Δx`, J.
    fn burnt(&self, moved: V, period: V::Scalar) -> V::Scalar;

    /// The size of an effort, with the gain `g` in `fᵀ D⁻¹ f = size² / g`.
    fn size(&self, effort: V) -> (V::Scalar, V::Scalar);
}

/// One damping `b` on every axis, N·s/m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EveryAxis<T>(pub(super) T);

impl<T: Scalar> EveryAxis<T> {
    pub(super) fn new(damping: T) -> Result<Self, ParameterError> {
        Ok(Self(Requirement::NonNegative.check("device damping", damping)?))
    }
}

impl<V: Signal> DeviceDamping<V> for EveryAxis<V::Scalar> {
    #[inline(always)]
    fn burnt(&self, moved: V, period: V::Scalar) -> V::Scalar {
        self.0 * (moved.inner(moved) / period)
    }

    #[inline(always)]
    fn size(&self, effort: V) -> (V::Scalar, V::Scalar) {
        (effort.inner(effort).sqrt(), self.0)
    }
}

/// A symmetric damping matrix that is above 0 in every direction, N·s/m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DampingMatrix<T: Scalar, const N: usize> {
    whole: SMatrix<T, N, N>,
    factors: Factors<T, N>,
}

impl<T: Scalar, const N: usize> DampingMatrix<T, N> {
    pub(super) fn new(damping: SMatrix<T, N, N>) -> Result<Self, ParameterError> {
        let whole = Factors::whole(damping);
        Ok(Self { whole, factors: Factors::of(damping, "device damping's pivot")? })
    }
}

impl<T: Scalar, const N: usize> DeviceDamping<SVector<T, N>> for DampingMatrix<T, N> {
    #[inline(always)]
    fn burnt(&self, moved: SVector<T, N>, period: T) -> T {
        let braked = SVector::<T, N>::from_fn(|row, _| {
            (0..N).fold(T::of(0.0), |sum, column| sum + self.whole[(row, column)] * moved[column])
        });
        moved.inner(braked) / period
    }

    #[inline(always)]
    fn size(&self, effort: SVector<T, N>) -> (T, T) {
        (self.factors.inverse_square(effort).sqrt(), T::of(1.0))
    }
}

mod sealed {
    use lyapunov_core::Scalar;

    /// Dampings of this crate: a bound is made with no other.
    pub trait Sealed {}

    impl<T> Sealed for super::EveryAxis<T> {}
    impl<T: Scalar, const N: usize> Sealed for super::DampingMatrix<T, N> {}
}
