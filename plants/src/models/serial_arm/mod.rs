//! Serial arm of revolute joints.

mod posture;

pub use posture::ArmPosture;

use lyapunov_core::{Mechanics, ParameterError, Pose, Requirement, Scalar, Signal};
use nalgebra::{Matrix3, SVector, UnitQuaternion, Vector3, Vector4};

use super::trigonometry::{cos, sin};
use crate::elimination::{positive_definite, solved};

/// A link of a [`SerialArm`] with the joint before it, by the parameters of Denavit and Hartenberg in Craig's form.
///
/// The link's axes follow from those of the link before it by a turn `twist` about x, a shift `length` along x, the
/// joint's angle about z and a shift `offset` along z (Craig, Introduction to Robotics, 2005, section 3.4).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArmLink<T> {
    /// `a(i−1)`, m.
    pub length: T,
    /// `α(i−1)`, rad.
    pub twist: T,
    /// `d(i)`, m.
    pub offset: T,
    /// Mass, kg.
    pub mass: T,
    /// Centre of mass along the link's axes from its origin, m.
    pub centre: Vector3<T>,
    /// Inertia about the centre of mass along the link's axes, kg·m².
    pub inertia: Matrix3<T>,
}

/// An arm of `N` rigid links in a row that turn about their joints, without gravity and friction:
/// `M(q) q̈ + c(q, q̇) = u`.
///
/// Without gravity it is what a controller meets behind the arm's own compensation of gravity. As [`Mechanics`] it is
/// moved by every integrator; the effort acts against the motion, so `u = −effort`. What depends on the posture alone,
/// the tool's pose, the Jacobian and the inertia, comes from [`at`](Self::at).
///
/// ```
/// use approx::assert_abs_diff_eq;
/// use lyapunov_core::Pose;
/// use lyapunov_plants::{ArmLink, SerialArm};
/// use nalgebra::{Matrix3, Vector2, Vector3};
/// // Two rods of 1 kg in a plane, 0.4 m and 0.3 m long.
/// let rod = |length: f64, before: f64| ArmLink {
///     length: before,
///     twist: 0.0,
///     offset: 0.0,
///     mass: 1.0,
///     centre: Vector3::x() * (length / 2.0),
///     inertia: Matrix3::from_diagonal(&(Vector3::new(0.0, 1.0, 1.0) * (length * length / 12.0))),
/// };
/// let tip = Pose::at(Vector3::x() * 0.3);
/// let arm = SerialArm::new([rod(0.4, 0.0), rod(0.3, 0.4)], tip)?;
/// let elbow = arm.at(Vector2::new(0.0, core::f64::consts::FRAC_PI_2));
/// assert!((elbow.tool().position - Vector3::new(0.4, 0.3, 0.0)).norm() < 1e-15);
/// assert_abs_diff_eq!(elbow.inertia()[(1, 1)], 0.3 * 0.3 / 3.0, epsilon = 1e-15);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SerialArm<T, const N: usize> {
    links: [ArmLink<T>; N],
    /// Sine and cosine of half of each twist.
    twists: [[T; 2]; N],
    tool: Pose<T>,
}

impl<T: Scalar, const N: usize> SerialArm<T, N> {
    /// The arm of these `links`, with its tool in the pose `tool` along the axes of the last one.
    ///
    /// # Errors
    /// A number that is infinite or NaN, also one of the `tool`, or a tool without an orientation: a quaternion of 0, or one whose
    /// square leaves the scalar's range; a mass below 0; an entry of an inertia that differs, by more than rounding, from the one
    /// across the diagonal; an inertia that leaves a joint without any: a pivot of `M(0)` that is not above 0.
    pub fn new(links: [ArmLink<T>; N], tool: Pose<T>) -> Result<Self, ParameterError> {
        for link in &links {
            Requirement::Finite.check("length", link.length)?;
            Requirement::Finite.check("twist", link.twist)?;
            Requirement::Finite.check("offset", link.offset)?;
            Requirement::NonNegative.check("mass", link.mass)?;
            for number in link.centre.iter().chain(link.inertia.iter()) {
                Requirement::Finite.check("centre or inertia", *number)?;
            }
            // An inertia turned by a rotation is symmetric but for rounding.
            let slack = T::of(16.0) * T::epsilon() * link.inertia.trace().magnitude();
            for (row, column) in [(1, 0), (2, 0), (2, 1)] {
                let across = link.inertia[(row, column)] - link.inertia[(column, row)];
                let none = Requirement::AtMost(0.0);
                none.check("inertia less its transpose", across.magnitude() - slack)?;
            }
        }
        Requirement::Finite.check_axes("tool", tool)?;
        // Its length is 1 where there is one, NaN or 0 elsewhere.
        let turn = tool.orientation().into_inner().coords;
        let length = turn.inner(turn);
        Requirement::InRange.require("tool's orientation", length, length.above(T::of(0.5)))?;
        let half = T::of(0.5);
        let twists = core::array::from_fn(|joint| {
            let angle = links[joint].twist * half;
            [sin(angle), cos(angle)]
        });
        let arm = Self { links, twists, tool };
        positive_definite(arm.at(SVector::zeros()).inertia(), "inertia's pivot")?;
        Ok(arm)
    }

    /// The arm with these `angles` of its joints, rad.
    #[inline]
    pub fn at(&self, angles: SVector<T, N>) -> ArmPosture<'_, T, N> {
        let mut before = Pose::at(Vector3::zeros());
        let frames = core::array::from_fn(|joint| {
            before = before.then(&self.relative(joint, angles[joint]));
            before
        });
        ArmPosture::new(self, frames, before.then(&self.tool))
    }

    /// The pose of a link along the axes of the one before it.
    #[inline]
    fn relative(&self, joint: usize, angle: T) -> Pose<T> {
        let ArmLink { length, offset, .. } = self.links[joint];
        let [a, b] = self.twists[joint];
        let half = angle * T::of(0.5);
        let (c, d) = (sin(half), cos(half));
        let quaternion = Vector4::new(a * d, -(a * c), b * c, b * d);
        let (two, one) = (T::of(2.0), T::of(1.0));
        let (sine, cosine) = (two * a * b, one - two * a * a);
        let position = Vector3::new(length, -(sine * offset), cosine * offset);
        Pose::new(position, UnitQuaternion::new_unchecked(quaternion.into()))
    }
}

impl<T: Scalar, const N: usize> Mechanics<SVector<T, N>> for SerialArm<T, N> {
    type Coordinates = SVector<T, N>;

    /// The accelerations of the joints, rad/s², under `effort`, N·m.
    #[inline]
    fn acceleration(
        &self,
        angles: SVector<T, N>,
        rates: SVector<T, N>,
        effort: SVector<T, N>,
    ) -> SVector<T, N> {
        let posture = self.at(angles);
        let bias = posture.torques(rates, SVector::zeros());
        solved(posture.inertia(), -(effort + bias))
    }
}
