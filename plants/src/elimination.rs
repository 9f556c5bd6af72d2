//! Gauss' elimination without row exchange, of symmetric matrices.

use lyapunov_core::{ParameterError, Requirement, Scalar};
use nalgebra::{SMatrix, SVector};

/// `Ok(())` if `matrix` is positive definite: its pivots are the squares of the Cholesky factor's diagonal.
pub(crate) fn positive_definite<T: Scalar, const N: usize>(
    mut matrix: SMatrix<T, N, N>,
    pivot: &'static str,
) -> Result<(), ParameterError> {
    for column in 0..N {
        Requirement::Positive.check(pivot, matrix[(column, column)])?;
        eliminate(&mut matrix, column);
    }
    Ok(())
}

/// The solution `x` of `matrix · x = right` for a matrix that is positive definite.
pub(crate) fn solved<T: Scalar, const N: usize>(
    mut matrix: SMatrix<T, N, N>,
    mut right: SVector<T, N>,
) -> SVector<T, N> {
    for column in 0..N {
        eliminate(&mut matrix, column);
        for row in column + 1..N {
            let part = matrix[(row, column)] * right[column];
            right[row] -= part;
        }
    }
    for column in (0..N).rev() {
        for other in column + 1..N {
            let part = matrix[(column, other)] * right[other];
            right[column] -= part;
        }
        right[column] = right[column] / matrix[(column, column)];
    }
    right
}

/// Eliminates one column below the diagonal.
fn eliminate<T: Scalar, const N: usize>(matrix: &mut SMatrix<T, N, N>, column: usize) {
    for row in column + 1..N {
        let factor = matrix[(row, column)] / matrix[(column, column)];
        for other in column + 1..N {
            let part = factor * matrix[(column, other)];
            matrix[(row, other)] -= part;
        }
        matrix[(row, column)] = factor;
    }
}
