//! Signal at the port of a rigid body.

use num_traits::Zero;

use crate::{Axes, Pose, Scalar, Screw, WorldAxes};

/// A twist or a wrench and, with it, the pose, which no effort acts on.
///
/// An environment receives only a sample, and the force on a body depends on its pose, so the sample carries it. The
/// port of a rigid body is thereby a port like any other, to be held, delayed, guarded and stabilized:
///
/// | of a sample or effort | `screw` | `pose` |
/// |---|---|---|
/// | `position` | the sum of the displacements since the start | the pose |
/// | `velocity` | the twist | 0, or the rate of its numbers |
/// | `displacement` | the twist that leads from the last pose to this one ([`Screw::between`]) | its difference |
/// | effort, `applied` | the wrench | no meaning |
/// | `work` | on each axis, J | 0 |
///
/// [`Readings::of_poses`](crate::Readings::of_poses) make such samples from poses that are read. The pose carries no power: the
/// [`sum`](crate::Signal::sum) over the axes, and with it work and `v²`, is over the screw alone.
///
/// ```
/// use lyapunov_core::{OnePort, Pose, PortSample, Screw, WithPose};
/// use nalgebra::{Isometry3, Vector3};
/// /// A torque that turns the body's z axis upright.
/// struct Upright { stiffness: f64 } // N·m
/// impl OnePort<WithPose<f64>> for Upright {
///     fn respond(&mut self, sample: &PortSample<WithPose<f64>>) -> WithPose<f64> {
///         let axis = sample.position.pose.to_world(Vector3::z());
///         WithPose::of(Screw::new(Vector3::zeros(), Vector3::z().cross(&axis) * self.stiffness))
///     }
/// }
/// let leaning = Pose::from(Isometry3::rotation(Vector3::x() * 0.5));
/// let at_rest = PortSample::starting(1e-3, WithPose::at(leaning), WithPose::default());
/// let effort = Upright { stiffness: 2.0 }.respond(&at_rest).screw; // acts against the turn
/// assert!((effort.rotation.x - 2.0 * 0.5_f64.sin()).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "T: Scalar + serde::Serialize",
        deserialize = "T: Scalar + serde::Deserialize<'de>"
    ))
)]
pub struct WithPose<T, F = WorldAxes> {
    /// The part that efforts act on.
    pub screw: Screw<T, F>,
    /// The part that is only observed.
    pub pose: Pose<T>,
}

impl<T: Scalar, F: Axes> WithPose<T, F> {
    /// `screw` without a pose: a twist, or a wrench.
    #[inline(always)]
    pub fn of(screw: Screw<T, F>) -> Self {
        Self { screw, pose: Pose::zero() }
    }

    /// The position of a body in `pose` that has not moved yet.
    #[inline]
    pub fn at(pose: Pose<T>) -> Self {
        Self { screw: Screw::zero(), pose }
    }
}

impl<T: Scalar, F: Axes> From<Screw<T, F>> for WithPose<T, F> {
    #[inline(always)]
    fn from(screw: Screw<T, F>) -> Self {
        Self::of(screw)
    }
}

impl<T: Scalar, F: Axes> Default for WithPose<T, F> {
    /// Nothing: no twist, no wrench.
    #[inline(always)]
    fn default() -> Self {
        Self::zero()
    }
}

crate::signal_of_parts! {
    #[inline(always)]
    impl[T: Scalar, F: Axes] WithPose<T, F>, in T, of screw, pose => Self { screw, pose };

    /// The sum over the axes of the screw.
    #[inline(always)]
    fn sum(self) -> T {
        self.screw.sum()
    }

    #[inline(always)]
    fn finite(self) -> T::Mask {
        self.screw.finite() & self.pose.finite()
    }
}
