//! Normal equations of up to four numbers.

use nalgebra::{Matrix4, Vector4};

/// The inverse of the summed squares of the `free` coefficients, 0 elsewhere; none where they cannot be told apart.
pub(super) fn inverse(known: &Matrix4<f64>, free: [bool; 4]) -> Option<Matrix4<f64>> {
    let scale = Vector4::from_fn(|it, _| {
        let size = known[(it, it)].sqrt();
        if free[it] && size > 0.0 { size.recip() } else { 0.0 }
    });
    let mut scaled =
        Matrix4::from_fn(|row, column| known[(row, column)] * scale[row] * scale[column]);
    for it in 0..4 {
        if scale[it] == 0.0 {
            if free[it] {
                return None;
            }
            scaled[(it, it)] = 1.0;
        }
    }
    let inverse = scaled.cholesky()?.inverse();
    Some(Matrix4::from_fn(|row, column| inverse[(row, column)] * scale[row] * scale[column]))
}
