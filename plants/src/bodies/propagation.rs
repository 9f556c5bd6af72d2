//! Exact motion of a linear body under a held input.

use lyapunov_core::Scalar;
use nalgebra::SMatrix;

/// `exp(A) − I`, without cancellation where `A` is small.
///
/// For `ẋ = M x + N u` with `u` held over `T`, the first rows of `exp([M N; 0 0] T) − I` are the increment form
/// `x += (Φ − I) x + Γ u` of the exact solution. Each entry is accurate to a few units in the last place of its
/// summands, which keeps an `f32` body from gaining energy by rounding. The entries have the type that construction
/// computes in ([`Scalar::Real`]).
///
/// The method is a Taylor polynomial of a halved matrix, then doubled by `E ← 2 E + E²` (scaling and squaring; Higham,
/// Functions of Matrices, 2008, chapter 10). An `A` that is not finite gives entries that are not finite.
pub fn held_input<R: Scalar<Mask = bool>, const N: usize>(
    matrix: SMatrix<R, N, N>,
) -> SMatrix<R, N, N> {
    let half = R::of(0.5);
    let mut scaled = matrix;
    let mut halvings = 0;
    while size(&scaled).above(half) && size(&scaled).finite() {
        scaled *= half;
        halvings += 1;
    }
    let mut polynomial = SMatrix::identity();
    for degree in (2..=degree::<R>()).rev() {
        let share = R::of(degree.into());
        polynomial = SMatrix::identity() + (scaled * polynomial).map(|entry| entry / share);
    }
    let mut increment = scaled * polynomial;
    for _ in 0..halvings {
        increment = increment * R::of(2.0) + increment * increment;
    }
    increment
}

/// The first degree `n` whose term, at most `0.5ⁿ / n!`, is far below one rounding.
fn degree<R: Scalar<Mask = bool>>() -> u8 {
    let far_below = R::epsilon() * R::of(4e-9);
    let (mut degree, mut term) = (1, R::of(0.5));
    while term.above(far_below) {
        degree += 1;
        term *= R::of(0.5) / R::of(degree.into());
    }
    degree
}

/// The largest sum of magnitudes in a row.
fn size<R: Scalar<Mask = bool>, const N: usize>(matrix: &SMatrix<R, N, N>) -> R {
    let of_row = |row: usize| (0..N).fold(R::zero(), |sum, at| sum + matrix[(row, at)].magnitude());
    (0..N).map(of_row).fold(R::zero(), |largest, row| row.larger(largest))
}

/// Each lane's matrix, by rows, rounded to the scalar.
pub(super) fn by_rows<T: Scalar, const N: usize>(
    matrix: impl Fn(usize) -> SMatrix<T::Real, N, N>,
) -> [[T; N]; N] {
    let mut rows = [[T::zero(); N]; N];
    for lane in 0..T::LANES {
        let matrix = matrix(lane);
        for (row, entries) in rows.iter_mut().enumerate() {
            for (column, entry) in entries.iter_mut().enumerate() {
                let others = *entry;
                let here = |at| if at == lane { matrix[(row, column)] } else { others.real(at) };
                *entry = T::from_reals(here);
            }
        }
    }
    rows
}
