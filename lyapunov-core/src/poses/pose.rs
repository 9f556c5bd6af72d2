//! Pose of a rigid body: where it is and how it is turned.

use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3, Vector4};

use super::logarithm::product;
use crate::{ParameterError, Requirement, Scalar, Signal};

/// A pose: the position of the body's reference point, m, and the orientation of the body.
///
/// It is made from nalgebra's `Isometry3`, or from a position and a `UnitQuaternion`. The quaternion need not have
/// length 1: from 2⁻³⁰ to 2³⁰ only its direction counts (beyond, the squares of `f32` leave its range), and `q` and `−q` are
/// the same orientation. A pose that holds a NaN, an infinity or a quaternion of 0 leads to displacements that are not
/// finite, which a stabilizer rejects. A track counts none to a quaternion whose fourth power leaves the range: it could
/// count none from there.
///
/// As a [`Signal`] it is seven numbers, those of the position and those of the quaternion `(i, j, k, w)`; sums and
/// differences of poses are numbers too and no poses. That is how a pose travels in a sample ([`WithPose`](crate::WithPose)).
///
/// ```
/// use lyapunov_core::Pose;
/// use nalgebra::{Isometry3, Vector3};
/// let quarter = Vector3::z() * core::f64::consts::FRAC_PI_2;
/// let pose = Pose::from(Isometry3::new(Vector3::new(1.0, 0.0, 0.0), quarter));
/// assert!((pose.point(Vector3::new(0.1, 0.0, 0.0)) - Vector3::new(1.0, 0.1, 0.0)).norm() < 1e-15);
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
pub struct Pose<T> {
    /// Position of the reference point in the world, m.
    pub position: Vector3<T>,
    /// `(i, j, k, w)`.
    pub(super) quaternion: Vector4<T>,
}

impl<T: Scalar> Pose<T> {
    /// The pose at `position` m with the given orientation.
    #[inline]
    pub fn new(position: Vector3<T>, orientation: UnitQuaternion<T>) -> Self {
        Self { position, quaternion: orientation.into_inner().coords }
    }

    /// The pose at `position` m with its axes along those of the world.
    #[inline]
    pub fn at(position: Vector3<T>) -> Self {
        let (zero, one) = (T::of(0.0), T::of(1.0));
        Self { position, quaternion: Vector4::new(zero, zero, zero, one) }
    }

    /// Lanes in which displacements can be counted from and to the quaternion: the squares of a product of two such are
    /// numbers.
    #[inline]
    pub(crate) fn is_turned(&self) -> T::Mask {
        let square = self.quaternion.dot(&self.quaternion);
        (square * square).finite() & !(square * square).below(T::smallest_normal())
    }

    /// `Ok(())` if displacements can be counted from this stored pose.
    pub(crate) fn counted_from(&self) -> Result<(), ParameterError> {
        Requirement::Finite.check_axes("stored position", self.position)?;
        let size = self.quaternion.map(Scalar::magnitude).sum();
        Requirement::InRange.require("size of a stored quaternion", size, self.is_turned())
    }

    /// The orientation, of length 1.
    #[inline]
    pub fn orientation(&self) -> UnitQuaternion<T> {
        let length = self.quaternion.dot(&self.quaternion).sqrt();
        UnitQuaternion::new_unchecked(self.quaternion.map(|number| number / length).into())
    }

    /// `vector`, given along the body's axes, along the world's.
    #[inline]
    pub fn to_world(&self, vector: Vector3<T>) -> Vector3<T> {
        self.turned(vector, self.quaternion.xyz())
    }

    /// `vector`, given along the world's axes, along the body's.
    #[inline]
    pub fn to_body(&self, vector: Vector3<T>) -> Vector3<T> {
        self.turned(vector, -self.quaternion.xyz())
    }

    /// The place in the world of a point of the body, given along the body's axes from its reference point, m.
    #[inline]
    pub fn point(&self, point: Vector3<T>) -> Vector3<T> {
        self.position + self.to_world(point)
    }

    /// The pose in the world of a body whose pose along this body's axes is `other`.
    #[inline]
    pub fn then(&self, other: &Self) -> Self {
        let quaternion = product(&self.quaternion, &other.quaternion);
        Self { position: self.point(other.position), quaternion }
    }

    #[inline]
    fn turned(&self, vector: Vector3<T>, axis: Vector3<T>) -> Vector3<T> {
        let twice = T::of(2.0) / self.quaternion.dot(&self.quaternion);
        let across = axis.cross(&vector) * twice;
        vector + across * self.quaternion.w + axis.cross(&across)
    }
}

impl<T: Scalar> From<Isometry3<T>> for Pose<T> {
    #[inline]
    fn from(Isometry3 { rotation, translation }: Isometry3<T>) -> Self {
        Self::new(translation.vector, rotation)
    }
}

impl<T: Scalar> From<Pose<T>> for Isometry3<T> {
    #[inline]
    fn from(pose: Pose<T>) -> Self {
        let translation = Translation3 { vector: pose.position };
        Self { rotation: pose.orientation(), translation }
    }
}

crate::signal_of_parts! {
    #[inline(always)]
    impl[T: Scalar] Pose<T>, in T, of position, quaternion => Self { position, quaternion };
}

// Numbers are compared, not orientations: `q` and `−q` are apart.
#[cfg(feature = "approx")]
crate::approximate!(impl[T: Scalar] Pose<T>, of T { position, quaternion });
