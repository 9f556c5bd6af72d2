//! The exact motion of a linear body under a held input.

use lyapunov_core::Scalar;
use nalgebra::SMatrix;

/// `exp(A) − I`, without cancellation where `A` is small.
///
/// For `ẋ = M x + N u` with `u` held over `T`, the first rows of `exp([M N; 0 0] T) − I` are the increment
/// form `x += (Φ − I) x + Γ u` of the exact solution. Each entry is accurate to a few units in the last place
/// of the terms it is summed from, which is what keeps an `f32` body from gaining energy by rounding.
///
/// A Taylor polynomial of a halved matrix, then doubled by `E ← 2 E + E²` (scaling and squaring; Higham,
/// Functions of Matrices, 2008, chapter 10). An `A` that is not finite gives what is not finite.
pub fn held_input<const N: usize>(matrix: SMatrix<f64, N, N>) -> SMatrix<f64, N, N> {
    const DEGREE: usize = 20; // 0.5^20 / 20! is far below one rounding
    let mut scaled = matrix;
    let mut halvings = 0;
    while size(&scaled) > 0.5 && size(&scaled) < f64::INFINITY {
        scaled *= 0.5;
        halvings += 1;
    }
    let mut polynomial = SMatrix::identity();
    for degree in (2..=DEGREE).rev() {
        polynomial = SMatrix::identity() + scaled * polynomial / degree as f64;
    }
    let mut increment = scaled * polynomial;
    for _ in 0..halvings {
        increment = increment * 2.0 + increment * increment;
    }
    increment
}

/// The largest sum of magnitudes in a row.
fn size<const N: usize>(matrix: &SMatrix<f64, N, N>) -> f64 {
    matrix.row_iter().map(|row| row.iter().map(|entry| entry.abs()).sum()).fold(0.0, f64::max)
}

/// Each lane's matrix, by rows, rounded to the scalar.
pub(super) fn by_rows<T: Scalar, const N: usize>(
    matrix: impl Fn(usize) -> SMatrix<f64, N, N>,
) -> [[T; N]; N] {
    let mut rows = [[T::zero(); N]; N];
    for lane in 0..T::LANES {
        let matrix = matrix(lane);
        for (row, entries) in rows.iter_mut().enumerate() {
            for (column, entry) in entries.iter_mut().enumerate() {
                let others = *entry;
                *entry =
                    T::from_lanes(
                        |at| {
                            if at == lane { matrix[(row, column)] } else { others.lane(at) }
                        },
                    );
            }
        }
    }
    rows
}
