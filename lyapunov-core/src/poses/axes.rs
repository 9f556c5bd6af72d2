//! Axes in which a twist or a wrench is given.

use core::fmt::Debug;

use nalgebra::Vector3;

use super::logarithm::{Turn, half_turn, product, rotation_vector};
use crate::{Angle, Pose, Scalar, Screw};

/// The axes of a [`Screw`]: [`WorldAxes`] or [`BodyAxes`].
///
/// Both refer to the body's own reference point, the one whose position a [`Pose`] gives, so a change of axes turns
/// velocity, angular velocity, force and torque alike, and moves no lever arm. `v` is always the velocity of that
/// point, and a torque is always about it.
///
/// ```
/// use lyapunov_core::{BodyAxes, Pose, Screw, WorldAxes};
/// use nalgebra::{Isometry3, Vector3};
/// // A tool that points down feels a push up as a push backwards.
/// let down = Pose::from(Isometry3::rotation(Vector3::x() * core::f64::consts::PI));
/// let push = Screw::<f64, WorldAxes>::new(Vector3::z() * 3.0, Vector3::zeros());
/// let felt: Screw<f64, BodyAxes> = push.along(&down);
/// assert!((felt.translation + Vector3::z() * 3.0).norm() < 1e-15);
/// ```
pub trait Axes: Copy + Debug + PartialEq + sealed::Sealed + 'static {
    /// `vector`, given along the world's axes, along these.
    fn from_world<T: Scalar>(pose: &Pose<T>, vector: Vector3<T>) -> Vector3<T>;

    /// `vector`, given along these axes, along the world's.
    fn to_world<T: Scalar>(pose: &Pose<T>, vector: Vector3<T>) -> Vector3<T>;

    /// The displacement that leads from one pose to another: [`Screw::between`].
    fn between<T: Angle>(from: &Pose<T>, to: &Pose<T>) -> Screw<T, Self>;

    /// The pose to which a displacement leads: [`Screw::moving`].
    fn moving<T: Angle>(displacement: Screw<T, Self>, from: &Pose<T>) -> Pose<T>;
}

/// The axes of the world, at the body's reference point: what the drivers of haptic devices and the geometric Jacobian
/// of an arm speak.
///
/// `displacement = (p₁ − p₀, log(R₁ R₀ᵀ))`. The work of a held force is exact for every motion; that of a held torque
/// is exact while the axis of rotation stands still ([`Screw::between`]).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WorldAxes;

/// The axes of the body, at its reference point: those of a force sensor, or of a tool.
///
/// `displacement = log(X₀⁻¹ X₁)`, the logarithm of rigid motions: exact for every constant twist.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BodyAxes;

impl Axes for WorldAxes {
    #[inline(always)]
    fn from_world<T: Scalar>(_pose: &Pose<T>, vector: Vector3<T>) -> Vector3<T> {
        vector
    }

    #[inline(always)]
    fn to_world<T: Scalar>(_pose: &Pose<T>, vector: Vector3<T>) -> Vector3<T> {
        vector
    }

    #[inline]
    fn between<T: Angle>(from: &Pose<T>, to: &Pose<T>) -> Screw<T, Self> {
        let (rotation, _) = rotation_vector(half_turn(from, to, |d, q| q.cross(&d)));
        Screw::new(to.position - from.position, rotation)
    }

    #[inline]
    fn moving<T: Angle>(displacement: Screw<T, Self>, from: &Pose<T>) -> Pose<T> {
        let turn = Turn::by(displacement.rotation).quaternion;
        let position = from.position + displacement.translation;
        Pose { position, quaternion: product(&turn, &from.quaternion) }
    }
}

impl Axes for BodyAxes {
    #[inline]
    fn from_world<T: Scalar>(pose: &Pose<T>, vector: Vector3<T>) -> Vector3<T> {
        pose.to_body(vector)
    }

    #[inline]
    fn to_world<T: Scalar>(pose: &Pose<T>, vector: Vector3<T>) -> Vector3<T> {
        pose.to_world(vector)
    }

    #[inline]
    fn between<T: Angle>(from: &Pose<T>, to: &Pose<T>) -> Screw<T, Self> {
        let (rotation, curl) = rotation_vector(half_turn(from, to, |d, q| d.cross(&q)));
        let moved = from.to_body(to.position - from.position);
        let across = rotation.cross(&moved);
        let translation = moved - across * T::of(0.5) + rotation.cross(&across) * curl;
        Screw::new(translation, rotation)
    }

    #[inline]
    fn moving<T: Angle>(displacement: Screw<T, Self>, from: &Pose<T>) -> Pose<T> {
        let Screw { translation, rotation, .. } = displacement;
        let turn = Turn::by(rotation);
        let (first, second) = turn.coefficients();
        let across = rotation.cross(&translation);
        let moved = translation + across * first + rotation.cross(&across) * second;
        let position = from.position + from.to_world(moved);
        Pose { position, quaternion: product(&from.quaternion, &turn.quaternion) }
    }
}

mod sealed {
    /// Axes of this crate: the equations of the others would be other equations.
    pub trait Sealed {}

    impl Sealed for super::WorldAxes {}
    impl Sealed for super::BodyAxes {}
}
