//! Inertia of an arm at its tool.

use lyapunov_core::{Axes, Jacobian, ParameterError, Scalar, Spatial};
use nalgebra::SMatrix;

use super::{Inertia, JointInertia};

/// Inertia of an arm at its tool, by its inverse `Λ⁻¹ = J M⁻¹ Jᵀ` (Khatib, IEEE Journal of Robotics and Automation 3(1), 1987).
///
/// `Λ` itself is not formed, so a singular posture, in which some direction does not yield, is nothing special.
///
/// ```
/// use lyapunov_core::{Jacobian, Screw, WorldAxes};
/// use lyapunov_stabilizers::{Inertia, TaskInertia};
/// use nalgebra::{Matrix1, Vector3};
/// // A rod of 0.06 kg·m² about its hinge, and its tip 0.5 m away: 0.24 kg across, nothing yields along.
/// let jacobian = Jacobian::<f64, 1, WorldAxes>::of([Screw::new(Vector3::y() * 0.5, Vector3::z())]);
/// let inertia = TaskInertia::new(&jacobian, Matrix1::new(0.06))?;
/// let force = |along| Screw::<f64, WorldAxes>::new(along, Vector3::zeros());
/// assert!((inertia.apparent(force(Vector3::y() * 3.0)) - 0.24).abs() < 1e-15);
/// assert_eq!(inertia.inverse_square(force(Vector3::x())), 0.0);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TaskInertia<T: Scalar, F, const N: usize> {
    jacobian: Jacobian<T, N, F>,
    joints: JointInertia<T, N>,
}

impl<T: Scalar, F: Axes, const N: usize> TaskInertia<T, F, N> {
    /// The inertia at the tool of joints with this `jacobian` and this `inertia`, kg·m², of which only the lower
    /// triangle is read.
    ///
    /// # Errors
    /// An inertia that is not positive definite, not finite, or so near to either that its digits do not decide.
    pub fn new(
        jacobian: &Jacobian<T, N, F>,
        inertia: SMatrix<T, N, N>,
    ) -> Result<Self, ParameterError> {
        Ok(Self { jacobian: *jacobian, joints: JointInertia::new(inertia)? })
    }
}

impl<V: Spatial, const N: usize> Inertia<V> for TaskInertia<V::Scalar, V::Axes, N> {
    #[inline]
    fn inverse_square(&self, effort: V) -> V::Scalar {
        self.joints.inverse_square(self.jacobian.torques(effort.screw()))
    }
}
