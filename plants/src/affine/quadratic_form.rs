//! Quadratic Lyapunov function.

use lyapunov_core::{LyapunovFunction, ParameterError, Requirement, Scalar, Signal};
use nalgebra::{SMatrix, SVector};

use crate::elimination::positive_definite;

/// The quadratic form `V = ½ xᵀ P x`, with `∇V = P x`.
///
/// For a linear plant `P` solves the Lyapunov equation `AᵀP + P A = −Q` of a stable loop, or comes from linear
/// quadratic design.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct QuadraticForm<T, const N: usize> {
    rows: [SVector<T, N>; N],
}

impl<T: Scalar, const N: usize> QuadraticForm<T, N> {
    /// The form of the symmetric matrix with these `rows`.
    ///
    /// # Errors
    /// An entry of `P` that is not finite, or that differs from the one across the diagonal; a `P` that is not
    /// positive definite: a pivot of its Cholesky factor (of an `f64` copy, lane by lane) not above 0.
    pub fn new(rows: [SVector<T, N>; N]) -> Result<Self, ParameterError> {
        for (i, row) in rows.iter().enumerate() {
            for (j, &entry) in row.iter().enumerate() {
                Requirement::Finite.check("P", entry)?;
                let across = (entry - rows[j][i]).magnitude();
                Requirement::AtMost(0.0).check("P less its transpose", across)?;
            }
        }
        for lane in 0..T::LANES {
            let alone = SMatrix::<f64, N, N>::from_fn(|i, j| rows[i][j].lane(lane));
            positive_definite(alone, "P's pivot")?;
        }
        Ok(Self { rows })
    }

    /// The form `V = ½ |x|²`.
    pub fn sum_of_squares() -> Self {
        let one = |i, j| if i == j { T::of(1.0) } else { T::of(0.0) };
        Self { rows: core::array::from_fn(|i| SVector::from_fn(|j, _| one(i, j))) }
    }
}

impl<T: Scalar, const N: usize> LyapunovFunction<SVector<T, N>> for QuadraticForm<T, N> {
    #[inline]
    fn value(&self, state: SVector<T, N>) -> T {
        T::of(0.5) * state.inner(self.gradient(state))
    }

    #[inline]
    fn gradient(&self, state: SVector<T, N>) -> SVector<T, N> {
        SVector::from(self.rows.map(|row| row.inner(state)))
    }
}
