//! Symmetric matrices that are above 0 in every direction.

use lyapunov_core::{ParameterError, Requirement, Scalar};
use nalgebra::{SMatrix, SVector};

/// The factors of `M = L D Lᵀ`: in one matrix, `D` on the diagonal and `L` below it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Factors<T: Scalar, const N: usize> {
    factors: SMatrix<T, N, N>,
}

impl<T: Scalar, const N: usize> Factors<T, N> {
    /// The symmetric matrix of a lower triangle.
    pub(crate) fn whole(matrix: SMatrix<T, N, N>) -> SMatrix<T, N, N> {
        SMatrix::from_fn(|row, column| matrix[(row.max(column), row.min(column))])
    }

    /// Of `matrix`, whose lower triangle is read; a `pivot` of that name that is not above 0 and finite is refused.
    pub(crate) fn of(
        matrix: SMatrix<T, N, N>,
        pivot: &'static str,
    ) -> Result<Self, ParameterError> {
        let mut factors = matrix;
        for column in 0..N {
            let diagonal = Requirement::Positive.check(pivot, factors[(column, column)])?;
            for row in (column + 1..N).rev() {
                let factor = factors[(row, column)] / diagonal;
                for other in column + 1..=row {
                    let part = factor * factors[(other, column)];
                    factors[(row, other)] -= part;
                }
                factors[(row, column)] = factor;
            }
        }
        Ok(Self { factors })
    }

    /// `aᵀ M⁻¹ a`.
    #[inline(always)]
    pub(crate) fn inverse_square(&self, a: SVector<T, N>) -> T {
        let (mut left, mut square) = (a, T::of(0.0));
        for column in 0..N {
            let part = left[column];
            square += part * part / self.factors[(column, column)];
            for row in column + 1..N {
                left[row] -= self.factors[(row, column)] * part;
            }
        }
        square
    }
}
