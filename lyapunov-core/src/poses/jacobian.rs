//! Jacobian of a mechanism: the twist of its tool for the rates of its joints.

use nalgebra::{SMatrix, SVector, Vector3};
use num_traits::Zero;

use crate::{Axes, Scalar, Screw, Signal, WorldAxes};

/// The Jacobian of `N` joints: for each joint the twist of the tool at a rate of one.
///
/// ```text
/// V = Σ sᵢ q̇ᵢ = J q̇     τᵢ = sᵢ · F, that is τ = Jᵀ F     τ · q̇ = F · V
/// ```
///
/// A wrench becomes torques by the same numbers by which rates become a twist, so power is the same on both sides,
/// whatever the posture. Joints turn (rad/s, N·m) or slide (m/s, N). The twist is that of the tool's reference point
/// along `F`; along the [`WorldAxes`] that is the geometric Jacobian.
///
/// ```
/// use lyapunov_core::{Jacobian, Screw, Signal, WorldAxes};
/// use nalgebra::{Vector2, Vector3};
/// let (shoulder, elbow) = (Vector3::new(0.5, 0.0, 0.0), Vector3::new(0.2, 0.0, 0.0)); // from each joint to the tool
/// let hinge = |arm: Vector3<f64>| Screw::new(Vector3::z().cross(&arm), Vector3::z());
/// let jacobian = Jacobian::<f64, 2, WorldAxes>::of([hinge(shoulder), hinge(elbow)]);
/// let (rates, wrench) = (Vector2::new(1.0, -2.0), Screw::new(Vector3::new(3.0, 4.0, 0.0), Vector3::zeros()));
/// let power: f64 = jacobian.torques(wrench).dot(&rates);
/// assert!((power - wrench.inner(jacobian.twist(rates))).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jacobian<T, const N: usize, F = WorldAxes> {
    joints: [Screw<T, F>; N],
}

impl<T: Scalar, F: Axes, const N: usize> Jacobian<T, N, F> {
    /// The Jacobian of these twists, one for each joint at a rate of one.
    pub fn of(joints: [Screw<T, F>; N]) -> Self {
        Self { joints }
    }

    /// The twist of the tool for these rates of the joints.
    #[inline]
    pub fn twist(&self, rates: SVector<T, N>) -> Screw<T, F> {
        let mut twist = Screw::zero();
        for (joint, screw) in self.joints.iter().enumerate() {
            twist = twist + screw.scale(rates[joint]);
        }
        twist
    }

    /// The torques of the joints that make up `wrench`.
    #[inline]
    pub fn torques(&self, wrench: Screw<T, F>) -> SVector<T, N> {
        SVector::from_fn(|joint, _| self.joints[joint].inner(wrench))
    }

    /// This Jacobian where all of it is finite, `other` elsewhere, lane by lane.
    #[inline]
    pub(super) fn or(&self, other: &Self) -> Self {
        let whole =
            self.joints.iter().fold(Screw::zero(), |sum, joint| sum + joint.scale(T::zero()));
        let finite = whole.finite();
        let joints = |joint: usize| Screw::choose(finite, self.joints[joint], other.joints[joint]);
        Self { joints: core::array::from_fn(joints) }
    }
}

/// Of a matrix of six rows: first translation, then rotation.
impl<T: Scalar, F: Axes, const N: usize> From<SMatrix<T, 6, N>> for Jacobian<T, N, F> {
    fn from(matrix: SMatrix<T, 6, N>) -> Self {
        let part =
            |joint: usize, first: usize| Vector3::from_fn(|axis, _| matrix[(first + axis, joint)]);
        Self { joints: core::array::from_fn(|joint| Screw::new(part(joint, 0), part(joint, 3))) }
    }
}
