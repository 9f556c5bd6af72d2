//! Track of poses: positions whose differences are displacements.

use crate::{
    Angle, Axes, ParameterError, Pose, Poses, Requirement, Screw, Signal, Snapshot, WithPose,
    WorldAxes,
};

/// Poses that are read, unrolled into positions that can be subtracted.
///
/// Two orientations have no difference, so the positions of a [`WithPose`] are sums of the displacements between one
/// reading and the next ([`Screw::between`]): a body that keeps turning goes on past π, and whatever takes
/// displacements from positions (a gap, a filter) is right on a port of poses too. The rounding of the sum
/// is carried along, so slow motion is not lost in it, and the sum of all differences is that of all displacements to
/// one unit in the last place.
///
/// A pose that is not finite gives a position that is not, and is forgotten; the next finite one is counted from the
/// last finite one.
///
/// ```
/// use approx::assert_abs_diff_eq;
/// use lyapunov_core::{Pose, PoseTrack, HeldTick, Signal, WithPose, WorldAxes};
/// use nalgebra::{Isometry3, Vector3};
/// let read = |angle: f64| Pose::from(Isometry3::rotation(Vector3::new(0.0, 0.0, angle)));
/// let mut track = PoseTrack::<f64, WorldAxes>::from(read(3.1));
/// let before = track.tell(&read(3.1)); // nothing has moved
/// let now = track.tell(&read(3.2)); // past half a turn
/// assert_abs_diff_eq!((now - before).screw.rotation.z, 0.1, epsilon = 1e-15);
/// let velocity = WithPose::of((now - before).screw.scale(1e3));
/// let sample = HeldTick { period: 1e-3, position: now, velocity, displacement: now - before, applied: WithPose::default() }.sample();
/// # let _ = sample;
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoseTrack<T, F = WorldAxes> {
    at: WithPose<T, F>,
    known: bool,
    steps: Poses<T, F>,
}

impl<T: Angle, F: Axes> From<Pose<T>> for PoseTrack<T, F> {
    /// The track that starts at `pose`.
    fn from(pose: Pose<T>) -> Self {
        let known = pose.position.finite() & pose.is_turned();
        Self { at: WithPose::at(pose), known, steps: Poses::new() }
    }
}

impl<T: Angle, F: Axes> PoseTrack<T, F> {
    /// The position of the body in `pose`.
    #[inline]
    pub fn tell(&mut self, pose: &Pose<T>) -> WithPose<T, F> {
        let (now, steps) = self.steps.step(&self.at, pose, self.known);
        if now.finite() {
            *self = Self { at: now, known: true, steps };
        }
        now
    }
}

impl<T: Angle, F: Axes> Snapshot for PoseTrack<T, F> {
    /// The last position, whether its pose is sound, and what the sum has rounded away.
    type State = (WithPose<T, F>, bool, Screw<T, F>);

    fn state(&self) -> Self::State {
        (self.at, self.known, self.steps.state())
    }

    fn restored(self, (at, known, left): Self::State) -> Result<Self, ParameterError> {
        Requirement::Finite.check_axes("stored position", at.screw)?;
        if known {
            at.pose.counted_from()?;
        }
        Ok(Self { at, known, steps: self.steps.restored(left)? })
    }
}
