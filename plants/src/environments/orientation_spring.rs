//! Orientation spring.

use lyapunov_core::{
    Angle, Axes, Dissipation, LyapunovCandidate, ParameterError, PortSample, Pose, Requirement,
    Scalar, Screw, Signal, WithPose,
};
use nalgebra::Vector3;

use crate::{DissipationOf, ForceLaw, Kinematics};

/// A spring and a damper that turn a body back to an orientation: `τ = k φ + b ω`, `S = ½ k θ²`.
///
/// `φ = log(R R_restᵀ)` is the rotation vector of the shortest rotation from the rest, and `θ = |φ| ≤ π` its angle. The
/// torque is the gradient of the stored energy, since `d/dt ½ |φ|² = φ·ω` in the axes of world and body alike. It has
/// the same stiffness in every direction and exerts no force. At half a turn from the rest the torque is `π k` either
/// way round and changes its sign as the body passes, while the energy is continuous.
///
/// ```
/// use approx::assert_abs_diff_eq;
/// use lyapunov_core::{OnePort, Pose, PortSample, WithPose, WorldAxes};
/// use lyapunov_plants::OrientationSpring;
/// use nalgebra::{Isometry3, Vector3};
/// let mut spring = OrientationSpring::new(2.0, 0.01)?; // N·m/rad, N·m·s/rad
/// let turned = Pose::from(Isometry3::rotation(Vector3::new(0.0, 0.0, 0.3)));
/// let at_rest: PortSample<WithPose<f64, WorldAxes>> =
///     PortSample::starting(1e-3, WithPose::at(turned), WithPose::default());
/// assert_abs_diff_eq!(spring.respond(&at_rest).screw.rotation.z, 0.6, epsilon = 1e-15);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrientationSpring<T> {
    stiffness: T,
    damper: Dissipation<T>,
    rest: Pose<T>,
}

impl<T: Scalar> OrientationSpring<T> {
    /// A spring of `stiffness` N·m/rad and `damping` N·m·s/rad, relaxed where the body's axes are those of the world.
    ///
    /// # Errors
    /// `stiffness` or `damping` below 0, infinite or NaN.
    pub fn new(stiffness: T, damping: T) -> Result<Self, ParameterError> {
        Ok(Self {
            stiffness: Requirement::NonNegative.check("stiffness", stiffness)?,
            damper: Dissipation::of(damping)?,
            rest: Pose::at(Vector3::zeros()),
        })
    }

    /// The same spring, relaxed in the orientation of `pose`.
    #[must_use]
    pub fn at(self, pose: Pose<T>) -> Self {
        Self { rest: pose, ..self }
    }

    /// The credit of its own damper, `b ω² T`.
    pub fn dissipation(&self) -> DissipationOf<Self> {
        DissipationOf(*self)
    }
}

impl<T: Angle> OrientationSpring<T> {
    #[inline]
    fn turned<F: Axes>(&self, pose: &Pose<T>) -> Vector3<T> {
        Screw::<T, F>::between(&self.rest, pose).rotation
    }
}

impl<T: Angle, F: Axes> ForceLaw<WithPose<T, F>> for OrientationSpring<T> {
    #[inline]
    fn force(&self, motion: &Kinematics<WithPose<T, F>>) -> WithPose<T, F> {
        let spring = self.turned::<F>(&motion.position.pose) * self.stiffness;
        let damper = motion.velocity.screw.rotation * self.damper.damping();
        WithPose::of(Screw::new(Vector3::zeros(), spring + damper))
    }

    fn stored(&self, motion: &Kinematics<WithPose<T, F>>) -> T {
        let turned = self.turned::<F>(&motion.position.pose);
        T::of(0.5) * self.stiffness * turned.inner(turned)
    }
}

impl<T: Angle, F: Axes> LyapunovCandidate<WithPose<T, F>> for DissipationOf<OrientationSpring<T>> {
    #[inline]
    fn decrease(&mut self, sample: &PortSample<WithPose<T, F>>) -> T {
        let rate = sample.velocity.screw.rotation;
        self.0.damper.decrease(&PortSample::starting(sample.period, Vector3::zeros(), rate))
    }
}
