//! Track of poses: positions whose differences are displacements.

use lyapunov::{
    HeldTick, OnePort, PortSample, Signal, Snapshot,
    effects::{Fallback, OnePortExt},
    poses::{BodyAxes, Pose, PoseTrack, Screw, WithPose, WorldAxes},
};
use nalgebra::{Isometry3, UnitQuaternion, Vector3};

use crate::support::{Dice, pose};

/// Turning slowly for long, in `f32` and far from the start: what is summed is what was turned.
#[test]
fn slow_motion_is_not_lost_in_a_large_sum() {
    let at = |angle: f64| {
        let turn = UnitQuaternion::from_scaled_axis(Vector3::z() * angle).into_inner();
        pose::<f32>(Vector3::zeros(), turn.coords.into())
    };
    let mut track = PoseTrack::<f32, WorldAxes>::from(at(0.0));
    for turn in 0..100 {
        track.tell(&at(f64::from(turn)));
    }
    let start = track.tell(&at(99.0)).screw.rotation.z;
    assert!((start - 99.0).abs() < 1e-4);
    // Steps of 1e-6 rad, an eighth of the distance between two numbers at 99.
    let mut moved = 0.0;
    let mut last = start;
    for tick in 1..=20_000 {
        let now = track.tell(&at(99.0 + 1e-6 * f64::from(tick))).screw.rotation.z;
        moved += f64::from(now - last);
        last = now;
    }
    assert!((moved - 0.02).abs() < 3e-5, "{moved}");
}

/// The differences are the displacements.
#[test]
fn differences_are_displacements() {
    let mut dice = Dice::of(31);
    let first: Pose<f64> = dice.pose();
    let mut track = PoseTrack::<f64, BodyAxes>::from(first);
    let (mut last, mut at) = (first, track.tell(&first));
    assert_eq!(at, WithPose::at(first));
    for _ in 0..1000 {
        let next: Pose<f64> = dice.pose();
        let now = track.tell(&next);
        let moved = (now - at).screw - Screw::between(&last, &next);
        assert!(moved.translation.norm() < 1e-12 && moved.rotation.norm() < 1e-12);
        assert_eq!(now.pose, next);
        (last, at) = (next, now);
    }
}

/// A bad reading is told and forgotten; the next good one spans the gap.
#[test]
fn a_bad_reading_is_forgotten() {
    let at = |angle: f64| Pose::from(Isometry3::rotation(Vector3::y() * angle));
    let bad = Pose::at(Vector3::new(0.0, f64::NAN, 0.0));
    let zero = pose(Vector3::zeros(), [0.0; 4]);
    let mut track = PoseTrack::<f64, WorldAxes>::from(at(0.0));
    let before = track.tell(&at(0.1));
    for reading in [bad, zero, bad] {
        assert!(!track.tell(&reading).finite());
    }
    let after = track.tell(&at(0.4));
    assert!(((after - before).screw.rotation.y - 0.3).abs() < 1e-15);

    // A track that starts badly starts at the first good reading.
    let mut track = PoseTrack::<f64, WorldAxes>::from(bad);
    assert!(!track.tell(&bad).finite());
    assert_eq!(track.tell(&at(0.4)), WithPose::at(at(0.4)));
}

/// Keeps the displacements that it is told.
struct Spy(Vec<PortSample<WithPose<f64>>>);

impl OnePort<WithPose<f64>> for Spy {
    fn respond(&mut self, sample: &PortSample<WithPose<f64>>) -> WithPose<f64> {
        self.0.push(*sample);
        WithPose::of(Screw::new(Vector3::zeros(), Vector3::y()))
    }
}

/// Behind a guard the sample after a gap spans it: periods, rotation and the work of the torque that was held.
#[test]
fn a_guard_spans_a_gap() {
    let at = |angle: f64| Pose::from(Isometry3::rotation(Vector3::y() * angle));
    let bad = Pose::at(Vector3::new(f64::NAN, 0.0, 0.0));
    let mut track = PoseTrack::<f64>::from(at(3.0));
    let (mut last, mut applied) = (track.tell(&at(3.0)), WithPose::default());
    let mut spy = Spy(Vec::new());
    let mut port = (&mut spy).guarded(Fallback::Hold);
    for reading in [at(3.0), at(3.1), bad, bad, at(3.4)] {
        let now = track.tell(&reading);
        let moved = now - last;
        let velocity = WithPose::of(moved.screw.scale(1e3));
        applied = port.respond(
            &HeldTick { period: 1e-3, position: now, velocity, displacement: moved, applied }
                .sample(),
        );
        if now.finite() {
            last = now;
        }
    }
    let [_, before, spanning] = spy.0[..] else { panic!("{}", spy.0.len()) };
    assert!((before.displacement.screw.rotation.y - 0.1).abs() < 1e-15);
    assert!((spanning.displacement.screw.rotation.y - 0.3).abs() < 1e-14);
    assert!((spanning.period - 3e-3).abs() < 1e-18);
    assert!((spanning.work.sum() - 0.3).abs() < 1e-14);
}

/// A pose carries no power: efforts and works are those of the screw.
#[test]
fn the_pose_carries_no_power() {
    let mut dice = Dice::of(32);
    let mut random = || WithPose::<f64> { screw: dice.screw(1.0, 1.0), pose: dice.pose() };
    for _ in 0..100 {
        let (at, velocity, moved, applied) = (random(), random(), random(), random());
        let sample =
            HeldTick { period: 1e-3, position: at, velocity, displacement: moved, applied }
                .sample();
        let work = applied.screw.translation.dot(&moved.screw.translation)
            + applied.screw.rotation.dot(&moved.screw.rotation);
        assert!((sample.work.sum() - work).abs() < 1e-15);
        assert!((applied.inner(velocity) - applied.screw.inner(velocity.screw)).abs() < 1e-15);
    }
    let lost = WithPose::<f64>::at(Pose::at(Vector3::new(f64::NAN, 0.0, 0.0)));
    assert!(!lost.finite() && WithPose::<f64>::default().finite());
}

/// Changing the axes changes no power, and a force off the reference point is the torque of its arm.
#[test]
fn power_is_the_same_along_all_axes() {
    let mut dice = Dice::of(33);
    for _ in 0..1000 {
        let pose: Pose<f64> = dice.pose();
        let (twist, wrench) = (dice.screw::<f64, WorldAxes>(1.0, 3.0), dice.screw(10.0, 2.0));
        let power = wrench.inner(twist);
        let (seen, felt): (Screw<f64, BodyAxes>, Screw<f64, BodyAxes>) =
            (twist.along(&pose), wrench.along(&pose));
        assert!((felt.inner(seen) - power).abs() < 1e-13);

        let (force, arm): (Vector3<f64>, Vector3<f64>) = (dice.vector(5.0), dice.vector(0.3));
        let here = Screw::<f64, WorldAxes>::of_force(force, arm).inner(twist);
        assert!((here - force.dot(&twist.velocity_at(arm))).abs() < 1e-13);
    }
}

#[test]
fn a_stored_track_that_nothing_can_be_counted_from_is_refused() {
    let start = pose::<f64>(Vector3::zeros(), [0.1, 0.2, 0.3, 0.9]);
    let mut track = PoseTrack::<f64, WorldAxes>::from(start);
    track.tell(&start);
    let (mut at, known, left) = track.state();
    assert!(track.restored((at, known, left)).is_ok());
    at.pose.position.x = f64::NAN;
    assert_eq!(track.restored((at, known, left)).expect_err("").parameter, "stored position");
    at.pose = start.scale(1e-165);
    let error = track.restored((at, known, left)).expect_err("no pose");
    assert_eq!(error.parameter, "size of a stored quaternion");
}
