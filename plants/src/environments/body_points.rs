//! Points of a rigid body in an environment.

use lyapunov_core::{Axes, OnePort, PortSample, Scalar, Screw, WithPose};
use nalgebra::{SVector, Vector3};
use num_traits::Zero;

use crate::{ForceLaw, Kinematics};

/// `N` points of a rigid body, each under the same force law in space: the corners of a tool against a wall.
///
/// ```text
/// xᵢ = p + R rᵢ,  vᵢ = v + ω × R rᵢ        the law's motion at each point
/// f = Σ fᵢ,  τ = Σ R rᵢ × fᵢ,  S = Σ Sᵢ    the wrench about the reference point, the stored energy
/// ```
///
/// Any [`ForceLaw`] on three axes serves: [`Contact`](crate::Contact) with a [`Solid`](crate::Solid), a
/// [`Spring`](crate::Spring) that pulls a point off the centre. `f·v + τ·ω = Σ fᵢ·vᵢ`, so the wrench does the work of
/// the forces. It has to be a law of position and velocity: time and acceleration of a point are not known here, and
/// are 0.
///
/// ```
/// use lyapunov_core::{OnePort, Pose, PortSample, WithPose, WorldAxes};
/// use lyapunov_plants::{BodyPoints, Contact, Plane};
/// use nalgebra::Vector3;
/// let floor = Contact::with(Plane::new(Vector3::zeros(), Vector3::z())?, 1000.0, 0.0)?;
/// let tip = Vector3::new(0.1, 0.0, -0.05);
/// let mut tool = BodyPoints::of(floor, [tip]);
/// let pose = Pose::at(Vector3::new(0.0, 0.0, 0.048)); // 2 mm deep
/// let sample: PortSample<WithPose<f64, WorldAxes>> =
///     PortSample::starting(1e-3, WithPose::at(pose), WithPose::default());
/// let effort = tool.respond(&sample).screw; // acts against the motion: 2 N up and 0.2 N·m
/// assert!((effort.translation.z + 2.0).abs() < 1e-12 && (effort.rotation.y - 0.2).abs() < 1e-12);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyPoints<L, T, const N: usize> {
    law: L,
    points: [Vector3<T>; N],
}

impl<L, T: Scalar, const N: usize> BodyPoints<L, T, N> {
    /// `points`, given along the body's axes from its reference point, m, under `law`.
    pub fn of(law: L, points: [Vector3<T>; N]) -> Self {
        Self { law, points }
    }

    /// The law's motion at one point of the body, and the arm to it along the world's axes.
    #[inline]
    fn motion<F: Axes>(
        point: Vector3<T>,
        body: &Kinematics<WithPose<T, F>>,
        twist: &Screw<T>,
    ) -> (Kinematics<SVector<T, 3>>, Vector3<T>) {
        let pose = &body.position.pose;
        let arm = pose.to_world(point);
        (Kinematics::at(pose.position + arm, twist.velocity_at(arm)), arm)
    }
}

impl<L, T, F, const N: usize> ForceLaw<WithPose<T, F>> for BodyPoints<L, T, N>
where
    T: Scalar,
    F: Axes,
    L: ForceLaw<SVector<T, 3>>,
{
    #[inline]
    fn force(&self, motion: &Kinematics<WithPose<T, F>>) -> WithPose<T, F> {
        let pose = &motion.position.pose;
        let twist = motion.velocity.screw.along(pose);
        let mut wrench = Screw::<T>::zero();
        for &point in &self.points {
            let (at, arm) = Self::motion(point, motion, &twist);
            wrench = wrench + Screw::of_force(self.law.force(&at), arm);
        }
        WithPose::of(wrench.along(pose))
    }

    fn stored(&self, motion: &Kinematics<WithPose<T, F>>) -> T {
        let twist = motion.velocity.screw.along(&motion.position.pose);
        self.points.iter().fold(T::of(0.0), |sum, &point| {
            sum + self.law.stored(&Self::motion(point, motion, &twist).0)
        })
    }
}

impl<L, T, F, const N: usize> OnePort<WithPose<T, F>> for BodyPoints<L, T, N>
where
    T: Scalar,
    F: Axes,
    L: ForceLaw<SVector<T, 3>>,
{
    #[inline]
    fn respond(&mut self, sample: &PortSample<WithPose<T, F>>) -> WithPose<T, F> {
        self.force(&Kinematics::of(sample))
    }
}
