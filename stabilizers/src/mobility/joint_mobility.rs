//! Mobility of an arm at its joints.

use lyapunov_core::{ParameterError, Scalar};
use nalgebra::{SMatrix, SVector};

use super::Mobility;
use crate::factors::Factors;

/// Mobility of `N` joints, `M⁻¹` with `M(q)` the inertia matrix of the arm.
///
/// ```
/// use lyapunov_stabilizers::{JointMobility, Mobility};
/// use nalgebra::{Matrix2, Vector2};
/// let mobility = JointMobility::new(Matrix2::new(0.5_f64, 0.1, 0.1, 0.1))?;
/// assert!((mobility.apparent(Vector2::x()) - 0.4).abs() < 1e-15); // kg·m², as the other joint gives way
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointMobility<T: Scalar, const N: usize> {
    factors: Factors<T, N>,
}

impl<T: Scalar, const N: usize> JointMobility<T, N> {
    /// The mobility of joints with this `inertia`, kg·m²; only its lower triangle is read.
    ///
    /// # Errors
    /// A matrix that is not positive definite, not finite, or so near to either that its digits do not decide.
    pub fn new(inertia: SMatrix<T, N, N>) -> Result<Self, ParameterError> {
        Ok(Self { factors: Factors::of(inertia, "inertia's pivot")? })
    }
}

impl<T: Scalar, const N: usize> Mobility<SVector<T, N>> for JointMobility<T, N> {
    #[inline]
    fn square(&self, effort: SVector<T, N>) -> T {
        self.factors.inverse_square(effort)
    }
}
