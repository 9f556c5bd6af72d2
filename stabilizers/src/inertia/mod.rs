//! Inertia of a mechanism at a port.

mod joint_inertia;
mod task_inertia;

pub use joint_inertia::JointInertia;
pub use task_inertia::TaskInertia;

use lyapunov_core::Signal;

/// Inertia `Λ` of the mechanism at a port in one posture, known by its inverse.
///
/// A force `e` that is held for a time `T` changes the motion by `Λ⁻¹ e T` and the kinetic energy by
/// `e·v T + ½ (e·Λ⁻¹ e) T²`. (An effort acts as the force `−e`.)
///
/// ```
/// use lyapunov_core::Signal;
/// use lyapunov_stabilizers::Inertia;
/// /// The same mass in every direction, kg.
/// struct Point(f64);
/// impl<V: Signal<Scalar = f64>> Inertia<V> for Point {
///     fn inverse_square(&self, effort: V) -> f64 {
///         effort.inner(effort) / self.0
///     }
/// }
/// assert_eq!(Point(0.5).apparent(3.0), 0.5);
/// ```
pub trait Inertia<V: Signal> {
    /// `e·Λ⁻¹ e`, W/s, not below 0: how much it yields to an effort.
    fn inverse_square(&self, effort: V) -> V::Scalar;

    /// The apparent mass along the direction of an effort, `(e·e) / (e·Λ⁻¹ e)`: kg for a force, kg·m² for a torque. An
    /// effort with both has none.
    #[inline]
    fn apparent(&self, along: V) -> V::Scalar {
        along.inner(along) / self.inverse_square(along)
    }
}
