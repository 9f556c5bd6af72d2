//! Inertia of an arm at its joints.

use lyapunov_core::{ParameterError, Scalar};
use nalgebra::{SMatrix, SVector};

use super::Inertia;
use crate::factors::Factors;

/// Inertia of `N` joints: the inertia matrix `M(q)` of an arm.
///
/// ```
/// use lyapunov_stabilizers::{JointInertia, Inertia};
/// use nalgebra::{Matrix2, Vector2};
/// let inertia = JointInertia::new(Matrix2::new(0.5_f64, 0.1, 0.1, 0.1))?;
/// assert!((inertia.apparent(Vector2::x()) - 0.4).abs() < 1e-15); // kg·m², as the other joint gives way
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointInertia<T: Scalar, const N: usize> {
    factors: Factors<T, N>,
}

impl<T: Scalar, const N: usize> JointInertia<T, N> {
    /// The inertia of joints with this matrix, kg·m²; only its lower triangle is read.
    ///
    /// # Errors
    /// A matrix that is not positive definite, not finite, or so near to either that its digits do not decide.
    pub fn new(inertia: SMatrix<T, N, N>) -> Result<Self, ParameterError> {
        Ok(Self { factors: Factors::of(inertia, "inertia's pivot")? })
    }
}

impl<T: Scalar, const N: usize> Inertia<SVector<T, N>> for JointInertia<T, N> {
    #[inline]
    fn inverse_square(&self, effort: SVector<T, N>) -> T {
        self.factors.inverse_square(effort)
    }
}
