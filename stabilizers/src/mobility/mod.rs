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
///
/// ```
/// use lyapunov_core::Signal;
/// use lyapunov_stabilizers::Mobility;
/// /// The same mass in every direction, kg.
/// struct Point(f64);
/// impl<V: Signal<Scalar = f64>> Mobility<V> for Point {
///     fn square(&self, effort: V) -> f64 {
///         effort.inner(effort) / self.0
///     }
/// }
/// assert_eq!(Point(0.5).apparent(3.0), 0.5);
/// ```
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
