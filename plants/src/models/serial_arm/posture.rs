//! Serial arm in one posture.

use lyapunov_core::{Jacobian, Pose, Scalar, Screw, WorldAxes};
use nalgebra::{SMatrix, SVector, Vector3};

use super::{ArmLink, SerialArm};

/// A [`SerialArm`] with given angles of its joints.
///
/// ```
/// use lyapunov_core::{Pose, Screw};
/// use lyapunov_plants::{ArmLink, SerialArm};
/// use nalgebra::{Matrix3, Vector1, Vector3};
/// let (centre, inertia) = (Vector3::x() * 0.2, Matrix3::identity() * 0.01);
/// let link = ArmLink { length: 0.0, twist: 0.0, offset: 0.0, mass: 1.0, centre, inertia };
/// let hinge = SerialArm::new([link], Pose::at(Vector3::x() * 0.5))?;
/// let posture = hinge.at(Vector1::new(0.0));
/// let push = Screw::new(Vector3::y() * 4.0, Vector3::zeros()); // N, across the link
/// assert_eq!(posture.jacobian().torques(push).x, 2.0); // N·m
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArmPosture<'a, T, const N: usize> {
    arm: &'a SerialArm<T, N>,
    frames: [Pose<T>; N],
    tool: Pose<T>,
}

impl<'a, T: Scalar, const N: usize> ArmPosture<'a, T, N> {
    pub(super) fn new(arm: &'a SerialArm<T, N>, frames: [Pose<T>; N], tool: Pose<T>) -> Self {
        Self { arm, frames, tool }
    }

    /// The pose of the tool.
    #[inline]
    pub fn tool(&self) -> &Pose<T> {
        &self.tool
    }

    /// The geometric Jacobian of the tool: of each joint with axis `z` at `o`, `(z × (p − o), z)`.
    #[inline]
    pub fn jacobian(&self) -> Jacobian<T, N, WorldAxes> {
        Jacobian::of(core::array::from_fn(|joint| {
            let axis = self.axis(joint);
            let arm = self.tool.position - self.frames[joint].position;
            Screw::new(axis.cross(&arm), axis)
        }))
    }

    /// The inertia matrix `M(q)` of the joints, kg·m²: for each joint what all the links beyond it put up against a
    /// turn, as one body (Walker and Orin, Journal of Dynamic Systems, Measurement, and Control 104(3), 1982).
    #[inline]
    pub fn inertia(&self) -> SMatrix<T, N, N> {
        let mut inertia = SMatrix::<T, N, N>::zeros();
        let mut beyond = Composite::none();
        for column in (0..N).rev() {
            beyond = beyond.with(&self.arm.links[column], &self.frames[column]);
            let axis = self.axis(column);
            let arm = beyond.centre - self.frames[column].position;
            let force = axis.cross(&arm) * beyond.mass;
            let moment = beyond.about(axis);
            for row in 0..=column {
                let arm = beyond.centre - self.frames[row].position;
                let torque = self.axis(row).dot(&(moment + arm.cross(&force)));
                inertia[(row, column)] = torque;
                inertia[(column, row)] = torque;
            }
        }
        inertia
    }

    /// The torques `M(q) q̈ + c(q, q̇)` of a motion with these `rates` and `accelerations`, by the recursion of Newton
    /// and Euler (Luh, Walker and Paul, Journal of Dynamic Systems, Measurement, and Control 102(2), 1980), along the
    /// world's axes.
    #[inline]
    pub fn torques(&self, rates: SVector<T, N>, accelerations: SVector<T, N>) -> SVector<T, N> {
        let mut loads = [(Vector3::zeros(), Vector3::zeros(), Vector3::zeros()); N];
        let (mut spin, mut turning) = (Vector3::zeros(), Vector3::zeros());
        let (mut origin, mut moving) = (Vector3::zeros(), Vector3::zeros());
        for (joint, load) in loads.iter_mut().enumerate() {
            let (link, frame) = (&self.arm.links[joint], &self.frames[joint]);
            let swept = |arm: Vector3<T>, spin: Vector3<T>, turning: Vector3<T>| {
                turning.cross(&arm) + spin.cross(&spin.cross(&arm))
            };
            moving += swept(frame.position - origin, spin, turning);
            origin = frame.position;
            let own = self.axis(joint) * rates[joint];
            turning += self.axis(joint) * accelerations[joint] + spin.cross(&own);
            spin += own;

            let arm = frame.to_world(link.centre);
            let force = (moving + swept(arm, spin, turning)) * link.mass;
            let moment = turned(link, frame, turning) + spin.cross(&turned(link, frame, spin));
            *load = (force, moment + arm.cross(&force), origin);
        }
        let (mut force, mut moment, mut beyond) = (Vector3::zeros(), Vector3::zeros(), origin);
        let mut torques = SVector::zeros();
        for (joint, (own, about, origin)) in loads.into_iter().enumerate().rev() {
            moment += (beyond - origin).cross(&force) + about;
            force += own;
            beyond = origin;
            torques[joint] = self.axis(joint).dot(&moment);
        }
        torques
    }

    #[inline]
    fn axis(&self, joint: usize) -> Vector3<T> {
        self.frames[joint].to_world(unit(2))
    }
}

/// Several links as one body, along the world's axes.
#[derive(Clone, Copy)]
struct Composite<T> {
    mass: T,
    centre: Vector3<T>,
    /// Columns of the inertia about the centre.
    inertia: [Vector3<T>; 3],
}

impl<T: Scalar> Composite<T> {
    fn none() -> Self {
        Self { mass: T::of(0.0), centre: Vector3::zeros(), inertia: [Vector3::zeros(); 3] }
    }

    /// The moment of momentum about the centre at a `rate`, rad/s.
    fn about(&self, rate: Vector3<T>) -> Vector3<T> {
        let [x, y, z] = self.inertia;
        x * rate.x + y * rate.y + z * rate.z
    }

    /// This and one more link.
    fn with(&self, link: &ArmLink<T>, frame: &Pose<T>) -> Self {
        let (place, mass) = (frame.point(link.centre), self.mass + link.mass);
        let some = mass.above(T::of(0.0));
        let share = T::choose(some, link.mass / mass, T::of(0.0));
        let apart = place - self.centre;
        // About the common centre two masses turn like one of m₁ m₂ / (m₁ + m₂) at their distance.
        let reduced = self.mass * share;
        let square = apart.dot(&apart) * reduced;
        let inertia = core::array::from_fn(|axis| {
            let unit = unit(axis);
            self.inertia[axis] + turned(link, frame, unit) + unit * square
                - apart * (apart[axis] * reduced)
        });
        Self { mass, centre: self.centre + apart * share, inertia }
    }
}

/// The moment of momentum of a link about its centre of mass at a `rate`, rad/s, along the world's axes.
#[inline]
fn turned<T: Scalar>(link: &ArmLink<T>, frame: &Pose<T>, rate: Vector3<T>) -> Vector3<T> {
    let own = frame.to_body(rate);
    let [x, y, z] = [0, 1, 2].map(|axis| link.inertia.column(axis) * own[axis]);
    frame.to_world(x + y + z)
}

#[inline]
fn unit<T: Scalar>(axis: usize) -> Vector3<T> {
    Vector3::from_fn(|row, _| T::of(if row == axis { 1.0 } else { 0.0 }))
}
