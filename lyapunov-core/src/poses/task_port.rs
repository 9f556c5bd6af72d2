//! Port of a tool, seen from the joints that move it.

use nalgebra::SVector;
use num_traits::Zero;

use crate::exact_sum::exact_sums;
use crate::{
    Axes, HeldTick, Jacobian, PortSample, Pose, Scalar, Screw, Signal, WithPose, WorldAxes,
};

/// Between the joints of an arm and a port at its tool: samples of the joints become samples of the tool, and a wrench
/// at the tool becomes torques, without a joule lost or made.
///
/// ```text
/// velocity      V(n)  = J(n) q̇(n)
/// displacement  ΔX(n) = J(n−1) Δq(n)         what held torques act over: F(n−1) · ΔX = τ(n−1) · Δq exactly
/// torques       τ(n)  = J(n)ᵀ F(n)           held until the next tick
/// work          on each axis F(n−1) ΔX(n), and an equal share of what the joints' work differs by
/// ```
///
/// What the drives hold over a tick is a torque in each joint, not a wrench at the tool, so the work that crosses the
/// port is that of the joints. The displacement is therefore the one on which the wrench does just that work; it
/// differs from the tool's own displacement by the square of `Δq`. Where the torques that acted are not those that
/// were asked (clipped, late), the joints' sample says so, and its work is still the sum that is booked; the parts of
/// translation and of rotation are then known only to their sum.
///
/// The joints' samples must be about this port alone: `applied` leaves out what gravity compensation and other tasks
/// add. A sample, pose or Jacobian that is not finite gives a sample that is not, and is forgotten.
///
/// ```
/// use lyapunov_core::{Jacobian, HeldTick, Pose, Screw, Signal, TaskPort, WithPose, WorldAxes};
/// use nalgebra::{Vector1, Vector3};
/// // One hinge, with its tool 0.5 m away.
/// let at = |q: f64| Vector3::new(0.5 * q.cos(), 0.5 * q.sin(), 0.0);
/// let jacobian = |q: f64| Jacobian::of([Screw::new(Vector3::z().cross(&at(q)), Vector3::z())]);
/// let pose = |q: f64| Pose::at(at(q));
/// let mut port = TaskPort::<f64, 1, WorldAxes>::starting(&pose(0.0), &jacobian(0.0));
/// let wrench = Screw::new(Vector3::new(0.0, 8.0, 0.0), Vector3::zeros());
/// let torque = port.torques(WithPose::of(wrench));
/// assert_eq!(torque.x, 4.0); // N·m
/// let [position, displacement] = [Vector1::new(0.01); 2];
/// let velocity = Vector1::new(10.0);
/// let moved = HeldTick { period: 1e-3, position, velocity, displacement, applied: torque }.sample();
/// let sample = port.tell(&moved, &pose(0.01), &jacobian(0.01));
/// assert!((sample.work.sum() - 0.04).abs() < 1e-15); // J
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TaskPort<T, const N: usize, F = WorldAxes> {
    at: WithPose<T, F>,
    /// The rest of the way that the position has no digits for.
    left: Screw<T, F>,
    jacobian: Jacobian<T, N, F>,
    asked: Screw<T, F>,
}

impl<T: Scalar, F: Axes, const N: usize> TaskPort<T, N, F> {
    /// A port whose tool stands in `pose`, where the joints have this `jacobian`.
    pub fn starting(pose: &Pose<T>, jacobian: &Jacobian<T, N, F>) -> Self {
        let (at, none) = (WithPose::at(*pose), Screw::zero());
        Self { at, left: none, jacobian: *jacobian, asked: none }
    }

    /// The tool's sample, from that of the joints, for the tool in `pose` with this `jacobian`.
    #[inline]
    pub fn tell(
        &mut self,
        joints: &PortSample<SVector<T, N>>,
        pose: &Pose<T>,
        jacobian: &Jacobian<T, N, F>,
    ) -> PortSample<WithPose<T, F>> {
        let before = self.at;
        let screw = self.jacobian.twist(joints.displacement);
        let displacement = WithPose { screw, pose: *pose - before.pose };
        let (sum, left) = exact_sums(before.screw, screw + self.left);
        let position = WithPose { screw: sum, pose: *pose };
        let velocity = WithPose::of(jacobian.twist(joints.velocity));
        let asked = WithPose::of(self.asked);
        let mut sample =
            HeldTick { period: joints.period, position, velocity, displacement, applied: asked }
                .sample();
        let unlike = joints.work.sum() - sample.work.sum();
        sample.work.screw = sample.work.screw + Screw::splat(unlike / T::of(6.0));

        self.left = Screw::choose(sum.finite(), left, self.left);
        self.at.screw = Screw::choose(sum.finite(), sum, before.screw);
        self.at.pose = Pose::choose(pose.finite(), *pose, before.pose);
        self.jacobian = jacobian.or(&self.jacobian);
        sample
    }

    /// The torques that make up the wrench of `effort` in the posture that was told last.
    #[inline]
    pub fn torques(&mut self, effort: WithPose<T, F>) -> SVector<T, N> {
        self.asked = effort.screw;
        self.jacobian.torques(effort.screw)
    }
}
