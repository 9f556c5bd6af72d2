//! Exact motion of a linear body under a held input.

#![expect(clippy::needless_range_loop, reason = "a zip of rows is not always inlined")]

use core::hint::black_box;

use lyapunov_core::lanes::apart;
use lyapunov_core::{Mask, Scalar};
use nalgebra::SMatrix;

/// `exp(A) − I`, without cancellation where `A` is small.
///
/// For `ẋ = M x + N u` with `u` held over `T`, the first rows of `exp([M N; 0 0] T) − I` are the increment form
/// `x += (Φ − I) x + Γ u` of the exact solution. Each entry is accurate to a few units in the last place of its
/// summands; of an undamped mode that turns by many radians, to about as many halves of a unit. Over a year that adds up: an
/// undamped `f32` body may gain or lose a third of its energy in ten million ticks. The entries have the type that construction
/// computes in ([`Scalar::Real`]).
///
/// The method is a Taylor polynomial of a halved matrix, then doubled by `E ← 2 E + E²` (scaling and squaring; Higham,
/// Functions of Matrices, 2008, chapter 10). An `A` that is not finite gives entries that are not finite.
#[inline(always)]
pub fn held_input<R: Scalar, const N: usize>(matrix: SMatrix<R, N, N>) -> SMatrix<R, N, N> {
    increments::<R, N, N>(matrix)
}

/// [`held_input`] of a matrix whose rows from `M` on are those of an input, all zero, with the same digits for less work.
#[inline(always)]
pub(super) fn increments<R: Scalar, const N: usize, const M: usize>(
    mut scaled: SMatrix<R, N, N>,
) -> SMatrix<R, N, N> {
    let (half, none, one) = (R::of(0.5), R::zero(), R::one());
    // In each lane.
    let (mut halvings, mut most) = (none, none);
    loop {
        let size = size(&scaled);
        let large = size.above(half) & size.finite();
        if !large.any() {
            break;
        }
        for entry in scaled.as_mut_slice() {
            apart::<R>();
            *entry = R::choose(large, *entry * half, *entry);
        }
        halvings += R::choose(large, one, none);
        most += one;
    }
    let (mut polynomial, mut next) = (SMatrix::zeros(), scaled);
    for share in (2..=degree::<R>()).rev().map(|degree| R::of(degree.into())) {
        for column in 0..N {
            for row in 0..M {
                apart::<R>();
                let unit = if row == column { one } else { none };
                polynomial.data.0[column][row] = unit + next.data.0[column][row] / share;
            }
        }
        multiply::<R, N, M>(&scaled, &polynomial, &mut next);
        // The rows of an input are those of the identity.
        for column in M..N {
            for row in 0..M {
                apart::<R>();
                next.data.0[column][row] += scaled.data.0[column][row];
            }
        }
    }
    let mut done = none;
    while done.below(most).any() {
        let (open, two) = (done.below(halvings), R::of(2.0));
        let square = &mut polynomial;
        multiply::<R, N, M>(&next, &next, square);
        for column in 0..N {
            for row in 0..M {
                apart::<R>();
                let entry = next.data.0[column][row];
                let doubled = entry * two + square.data.0[column][row];
                next.data.0[column][row] = R::choose(open, doubled, entry);
            }
        }
        done += one;
    }
    next
}

/// The first `M` rows of a matrix product, of factors whose other rows count as zero, into `all`. That of nalgebra is not always
/// inlined, and so computes lanes on the base set of instructions; and the compiler finds the vectors of lanes between a read and a
/// write.
#[inline(always)]
fn multiply<R: Scalar, const N: usize, const M: usize>(
    one: &SMatrix<R, N, N>,
    other: &SMatrix<R, N, N>,
    all: &mut SMatrix<R, N, N>,
) {
    for column in 0..N {
        for row in 0..M {
            apart::<R>();
            let mut sum = one.data.0[0][row] * other.data.0[column][0];
            for at in 1..M {
                sum += one.data.0[at][row] * other.data.0[column][at];
            }
            all.data.0[column][row] = sum;
        }
    }
}

/// The matrix of these rows, times `factor`.
#[inline(always)]
pub(super) fn scaled<R: Scalar, const N: usize>(rows: &[[R; N]; N], factor: R) -> SMatrix<R, N, N> {
    let mut all = SMatrix::zeros();
    for column in 0..N {
        for row in 0..N {
            apart::<R>();
            all.data.0[column][row] = rows[row][column] * factor;
        }
    }
    all
}

/// The first degree `n` whose term, at most `0.5ⁿ / n!`, is far below one rounding.
#[inline(always)]
fn degree<R: Scalar>() -> u8 {
    let far_below = R::epsilon().lane(0) * 4e-9;
    let (mut degree, mut term) = (1, 0.5);
    while term > far_below {
        degree += 1;
        term *= 0.5 / f64::from(degree);
    }
    degree
}

/// The largest sum of magnitudes in a row.
#[inline(always)]
fn size<R: Scalar, const N: usize>(matrix: &SMatrix<R, N, N>) -> R {
    let mut largest = R::zero();
    for row in 0..N {
        apart::<R>();
        let mut sum = R::zero();
        for column in &matrix.data.0 {
            sum += column[row].magnitude();
        }
        largest = sum.larger(largest);
    }
    largest
}

/// Whether the lanes have all digits of construction, so that it may compute them at once.
#[inline(always)]
pub(super) fn has_all_digits<T: Scalar>() -> bool {
    T::epsilon().real(0) == T::Real::epsilon()
}

/// The first `M` rows of `matrix`.
#[inline(always)]
pub(super) fn rows<T: Scalar, const N: usize, const M: usize>(
    matrix: &SMatrix<T, N, N>,
) -> [[T; N]; M] {
    let mut all = [[T::zero(); N]; M];
    for column in 0..N {
        for row in 0..M {
            apart::<T>();
            all[row][column] = matrix.data.0[column][row];
        }
    }
    all
}

/// The first `M` rows of each lane's matrix, rounded to the scalar.
pub(super) fn by_rows<T: Scalar, const N: usize, const M: usize>(
    matrix: impl Fn(usize) -> SMatrix<T::Real, N, N>,
) -> [[T; N]; M] {
    let mut all = [[T::zero(); N]; M];
    // Counts that the compiler does not know keep it from writing the loops out, as entries times lanes times lanes.
    for lane in 0..black_box(T::LANES) {
        let matrix = matrix(lane);
        for (column, numbers) in matrix.data.0.iter().take(black_box(N)).enumerate() {
            for (row, number) in all.iter_mut().zip(numbers).take(black_box(M)) {
                let others = row[column];
                row[column] =
                    T::from_reals(|at| if at == lane { *number } else { others.real(at) });
            }
        }
    }
    all
}
