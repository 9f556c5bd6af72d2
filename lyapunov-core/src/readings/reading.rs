//! Reading of a device.

/// Reading of a device: where it stands, and the effort that acted since the reading before.
///
/// ```
/// use lyapunov_core::Reading;
/// use nalgebra::Vector3;
/// let (position, applied) = (Vector3::new(0.3, 0.0, 0.1), Vector3::zeros());
/// let reading: Reading<Vector3<f64>> = Reading { position, applied };
/// # let _ = reading;
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Reading<V, P = V> {
    /// Position now, m; or a pose.
    pub position: P,
    /// Effort that the motors really applied since the last reading, N: after saturation, and 0 before the first.
    pub applied: V,
}

/// Reading of a device that measures its velocity as well.
///
/// ```
/// use lyapunov_core::{MovingReading, Pose, Screw, WithPose};
/// use nalgebra::Vector3;
/// // of a rigid body: the pose, the twist, and the wrench that acted
/// let twist = Screw::new(Vector3::x() * 0.1, Vector3::zeros());
/// let reading: MovingReading<WithPose<f64>, Pose<f64>> = MovingReading {
///     position: Pose::at(Vector3::zeros()), velocity: WithPose::of(twist), applied: WithPose::default(),
/// };
/// # let _ = reading;
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct MovingReading<V, P = V> {
    /// Position now, m; or a pose.
    pub position: P,
    /// Velocity now, m/s.
    pub velocity: V,
    /// Effort that the motors really applied since the last reading, N: after saturation, and 0 before the first.
    pub applied: V,
}
