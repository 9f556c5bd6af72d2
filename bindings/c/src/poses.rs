//! Poses in C, and readings of them.

use lyapunov::poses::{Angle, Pose, Screw, WithPose};
use lyapunov::{CheckedSample, PortSample};
use nalgebra::{Quaternion, UnitQuaternion, Vector4};

use crate::check;
use crate::export::form;
use crate::kept::{Kind, Storage};
use crate::number::Number;
use crate::port::ScrewForm;
use crate::readings::{self, CheckedForm};

form! {
    /// Pose of a rigid body, in C `lyapunov_f64pose` and kin.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct PoseForm<T> {
        /// Position of the reference point, m.
        pub position: [T; 3],
        /// Orientation as a quaternion: x, y, z, w. Of length near 1: the length is divided out, but a change of it by orders
        /// of magnitude costs digits. Of length 0 it is no orientation, and the reading is rejected.
        pub quaternion: [T; 4],
    }
}

impl<T: Number> PoseForm<T> {
    /// The pose. A length other than 1 is no matter: whatever uses a pose divides by it.
    fn pose(self) -> Pose<T> {
        let quaternion = Quaternion::from(Vector4::from(self.quaternion));
        Pose::new(self.position.into(), UnitQuaternion::new_unchecked(quaternion))
    }
}

/// The sample of a pose as one of twist and wrench, which is all that C's stabilizers look at.
#[inline]
pub fn seen<T: Angle>(checked: CheckedSample<WithPose<T>>) -> CheckedSample<Screw<T>> {
    let CheckedSample { sample, accepted, jumped, late, timed } = checked;
    let PortSample { period, position, velocity, displacement, applied, work } = sample;
    let sample = PortSample {
        period,
        position: position.screw,
        velocity: velocity.screw,
        displacement: displacement.screw,
        applied: applied.screw,
        work: work.screw,
    };
    CheckedSample { sample, accepted, jumped, late, timed }
}

/// A reading of a pose through `read`.
///
/// # Safety
/// As [`init`](crate::verbs::init).
#[inline(always)]
pub unsafe fn read<T: Number + Angle, K: Kind<Port = Screw<T>>, const N: usize>(
    storage: *mut Storage<K>,
    pose: *const PoseForm<T>,
    given: [*const ScrewForm<T>; N],
    checked: *mut CheckedForm<Screw<T>>,
    read: impl FnOnce(&mut K::Body, Pose<T>, [WithPose<T>; N]) -> CheckedSample<WithPose<T>>,
) -> u32 {
    // SAFETY: as the caller says; the pose is checked before it is read, and read before the storage is lent.
    unsafe {
        if check::pointer(pose).is_err() {
            return readings::refuse(storage.cast(), [pose.cast::<ScrewForm<T>>()], checked);
        }
        let pose = pose.read().pose();
        readings::read(storage, given, checked, |body, given| {
            seen(read(body, pose, given.map(WithPose::of)))
        })
    }
}
