//! Mobility of a mechanism: how much it yields to an effort.

mod joint_mobility;
mod task_mobility;

pub use joint_mobility::JointMobility;
pub use task_mobility::TaskMobility;

use lyapunov_core::Signal;

/// Mobility of the mechanism at a port in one posture, the inverse `Λ⁻¹` of its inertia there.
///
/// An effort `e` that is held for a time `T` changes the motion by `Λ⁻¹ e T` and the kinetic energy by
/// `e·v T + ½ (e·Λ⁻¹ e) T²`.
pub trait Mobility<V: Signal> {
    /// `e·Λ⁻¹ e`, W/s: not below 0.
    fn square(&self, effort: V) -> V::Scalar;

    /// The apparent mass along the direction of an effort, `(e·e) / (e·Λ⁻¹ e)`: kg for a force, kg·m² for a torque. An
    /// effort with both has none.
    #[inline]
    fn apparent(&self, along: V) -> V::Scalar {
        along.inner(along) / self.square(along)
    }
}
