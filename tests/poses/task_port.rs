//! Between joints and tool: not a joule is lost or made.

use lyapunov::{
    HeldTick, PortSample, Signal,
    poses::{Jacobian, Pose, Screw, TaskPort, WithPose},
};
use nalgebra::{SVector, Vector3};

use crate::arm::{Joints, joints, panda};
use crate::support::Dice;

/// Over random motions and wrenches the work at the tool is that of the torques that were held, tick by tick, axis sums
/// and totals, whatever part of the torques was applied.
#[test]
fn the_work_at_the_tool_is_that_of_the_joints() {
    let (arm, mut dice) = (panda(), Dice::of(101));
    let mut angles = joints(&mut dice, 1.5);
    let start = arm.at(angles);
    let mut port = TaskPort::starting(start.tool(), &start.jacobian());
    let mut torque = Joints::zeros();
    for tick in 0..2000 {
        let clipped = tick % 2 == 1;
        let applied = if clipped { torque.map(|it: f64| it.clamp(-0.5, 0.5)) } else { torque };
        let moved = joints(&mut dice, 1e-3);
        let before = arm.at(angles);
        angles += moved;
        let posture = arm.at(angles);
        let sample = HeldTick {
            period: 1e-3,
            position: angles,
            velocity: moved / 1e-3,
            displacement: moved,
            applied,
        }
        .sample();
        let told = port.tell(&sample, posture.tool(), &posture.jacobian());

        let size = applied.abs().dot(&moved.abs()) + torque.abs().dot(&moved.abs());
        assert!((told.work.sum() - applied.dot(&moved)).abs() < 1e-14 * size.max(1e-3));
        let asked = told.applied.screw;
        assert!(
            (asked.inner(told.displacement.screw) - torque.dot(&moved)).abs()
                < 1e-15 + 1e-14 * size
        );
        if !clipped {
            let work = asked.translation.dot(&told.displacement.screw.translation);
            assert!((told.work.screw.translation.sum() - work).abs() < 1e-14 * size.max(1e-3));
        }
        let twist = posture.jacobian().twist(moved / 1e-3);
        assert_eq!(told.velocity.screw, twist);
        assert_eq!(told.position.pose, *posture.tool());

        // Where the tool went differs by the square of the joints' displacement.
        let true_one = Screw::<f64>::between(before.tool(), posture.tool());
        let apart = true_one - told.displacement.screw;
        let bound = moved.norm_squared() * 2.0;
        assert!(apart.translation.norm() < bound && apart.rotation.norm() < bound);

        let wrench = dice.screw(10.0, 2.0);
        torque = port.torques(WithPose::of(wrench));
        let power = torque.dot(&sample.velocity);
        assert!((power - wrench.inner(twist)).abs() < 1e-11);
    }
}

/// A sample that is not finite is told and forgotten, whichever part of it is bad.
#[test]
fn a_bad_sample_is_forgotten() {
    let arm = panda();
    let angles = Joints::from_element(0.3);
    let posture = arm.at(angles);
    let (tool, jacobian) = (*posture.tool(), posture.jacobian());
    let still = PortSample::starting(1e-3, angles, Joints::zeros());
    let moved = Joints::from_element(1e-3);
    let sound = HeldTick {
        period: 1e-3,
        position: angles + moved,
        velocity: moved / 1e-3,
        displacement: moved,
        applied: Joints::zeros(),
    }
    .sample();
    let lost = Joints::from_element(f64::NAN);
    let nowhere = Pose::at(Vector3::new(f64::NAN, 0.0, 0.0));
    let broken = Jacobian::of([Screw::splat(f64::INFINITY); 7]);

    let mut fresh = TaskPort::starting(&tool, &jacobian);
    fresh.tell(&still, &tool, &jacobian);
    let expected = fresh.tell(&sound, &tool, &jacobian);
    for bad in 0..3 {
        let mut port = TaskPort::starting(&tool, &jacobian);
        let told = match bad {
            0 => port.tell(&PortSample { displacement: lost, ..still }, &tool, &jacobian),
            1 => port.tell(&still, &nowhere, &jacobian),
            _ => port.tell(&still, &tool, &broken),
        };
        assert!(!told.finite(), "{bad}");
        assert_eq!(port.tell(&sound, &tool, &jacobian), expected, "{bad}");
    }
}

/// Joints that slide are joints too: a gantry is its own tool.
#[test]
fn a_gantry_is_its_own_tool() {
    let slide = |along| Screw::<f64>::new(along, Vector3::zeros());
    let jacobian = Jacobian::of([slide(Vector3::x()), slide(Vector3::y()), slide(Vector3::z())]);
    let mut port = TaskPort::starting(&Pose::at(Vector3::zeros()), &jacobian);
    let wrench = Screw::new(Vector3::new(1.0, 2.0, 3.0), Vector3::new(9.0, 9.0, 9.0));
    let forces: SVector<f64, 3> = port.torques(WithPose::of(wrench));
    assert_eq!(forces, wrench.translation);
}

/// In `f32` a way of 2 m still takes 0.1 µm a tick.
#[test]
fn a_long_way_in_single_precision() {
    let hinge = Jacobian::<f32, 1>::of([Screw::new(Vector3::x(), Vector3::zeros())]);
    let pose = Pose::at(Vector3::zeros());
    let mut port = TaskPort::starting(&pose, &hinge);
    let [position, displacement] = [SVector::<f32, 1>::new(0.0), SVector::<f32, 1>::new(1e-7)];
    let (velocity, applied) = (displacement * 1e3, position);
    let moved = HeldTick { period: 1e-3, position, velocity, displacement, applied }.sample();
    let told = (0..24_000_000).map(|_| port.tell(&moved, &pose, &hinge)).last().expect("ticks");
    assert!((told.position.screw.translation.x - 2.4).abs() < 1e-5, "{told:?}");
}
