//! Comparison within a tolerance: values that pass, and values that do not.

use approx::{
    abs_diff_eq, assert_abs_diff_eq, assert_relative_eq, assert_ulps_eq, relative_eq, ulps_eq,
};
use lyapunov::lanes::AutoF64x4;
use lyapunov::{
    AdmittanceSample, Correction, DampingLimit, HeldFlow, HeldTick, PortSample, Scalar,
    accumulators::DoubleDouble,
    bodies::{DampedMass, ElasticJoint, Impedance, TwoMassParts},
    integrators::State,
    poses::{Pose, Screw, WithPose},
    stabilizers::PartLimits,
};
use nalgebra::{Vector1, Vector2, Vector3};

#[test]
fn every_field_counts_by_its_own_unit() {
    let sample =
        HeldTick { period: 1e-3, position: 0.1, velocity: 0.2, displacement: 3e-4, applied: 5.0 }
            .sample();
    let changes: [fn(&mut PortSample<f64>) -> &mut f64; 6] = [
        |sample| &mut sample.period,
        |sample| &mut sample.position,
        |sample| &mut sample.velocity,
        |sample| &mut sample.displacement,
        |sample| &mut sample.applied,
        |sample| &mut sample.work,
    ];
    for change in changes {
        let mut other = sample;
        *change(&mut other) += 1e-6;
        assert!(!abs_diff_eq!(sample, other, epsilon = 0.9e-6));
        assert_abs_diff_eq!(sample, other, epsilon = 1.1e-6);
        assert!(!relative_eq!(sample, other, max_relative = 1e-8));
        assert!(!ulps_eq!(sample, other));
    }
    let load =
        HeldFlow { period: 1e-3, momentum: 0.1, effort: 0.2, impulse: 3e-4, flow: 5.0 }.sample();
    assert!(!abs_diff_eq!(load, AdmittanceSample { flow: 5.1, ..load }, epsilon = 0.09));
    assert_relative_eq!(load, AdmittanceSample { flow: 5.1, ..load }, max_relative = 0.02);
}

#[test]
fn every_axis_and_part_counts() {
    let screw = Screw::<f64>::new(Vector3::x(), Vector3::y());
    let turned = Screw::new(Vector3::x(), Vector3::y() * 1.001);
    assert_relative_eq!(screw, turned, max_relative = 2e-3);
    assert!(!abs_diff_eq!(screw, turned, epsilon = 0.9e-3));
    let [here, there] = [0.3, 0.301].map(|z| Pose::at(Vector3::z() * z));
    assert_abs_diff_eq!(here, there, epsilon = 1.1e-3);
    assert!(!abs_diff_eq!(here, there, epsilon = 0.9e-3));
    let turned_pose = |angle: f64| Pose::from(nalgebra::Isometry3::rotation(Vector3::x() * angle));
    // Half of the angle is the difference of the quaternions, to the first order.
    assert_relative_eq!(turned_pose(0.0), turned_pose(2e-3), epsilon = 1.1e-3);
    assert!(!relative_eq!(turned_pose(0.0), turned_pose(2e-3), epsilon = 0.9e-3));
    let with_pose = |screw, pose| WithPose::<f64> { screw, pose };
    assert_abs_diff_eq!(with_pose(screw, here), with_pose(turned, there), epsilon = 1.1e-3);
    assert!(!ulps_eq!(with_pose(screw, here), with_pose(turned, here)));
    assert!(!ulps_eq!(with_pose(screw, here), with_pose(screw, there)));
    let limit = |most| DampingLimit::at(most).expect("a limit");
    let limits = |rotation| PartLimits { translation: limit(9.0), rotation: limit(rotation) };
    assert!(!relative_eq!(limits(1.0), limits(1.1), max_relative = 0.01));
    assert_relative_eq!(limits(1.0), limits(1.1), max_relative = 0.1);

    let at = State { position: Vector2::new(1.0, 2.0), velocity: Vector2::new(0.0, 1e3) };
    let mut moved = at;
    moved.velocity.y += 1e-6;
    assert_relative_eq!(at, moved, max_relative = 1e-8);
    assert!(!abs_diff_eq!(at, moved, epsilon = 1e-7));
    moved.position.x = f64::NAN;
    assert!(!relative_eq!(at, moved, epsilon = 1e3, max_relative = 1.0));

    let operator = Impedance { mass: 1.0_f32, damping: 2.0, stiffness: 3.0 };
    let device = DampedMass { mass: 0.1, damping: 0.2 };
    let pair =
        TwoMassParts { operator, device, link: ElasticJoint { stiffness: 30.0, damping: 0.3 } };
    let other =
        TwoMassParts { link: ElasticJoint { stiffness: 30.0_f32.next_up(), damping: 0.3 }, ..pair };
    assert_ulps_eq!(pair, other, max_ulps = 1);
    assert!(!ulps_eq!(pair, other, epsilon = 0.0, max_ulps = 0));

    let limit = |most: f64| DampingLimit::at(most).expect("a limit");
    assert_abs_diff_eq!(limit(10.0), limit(10.1), epsilon = 0.2);
    assert!(!abs_diff_eq!(limit(10.0), limit(10.1), epsilon = 0.05));
}

#[test]
fn acceptance_is_compared_exactly() {
    let none = Correction::none(1.0);
    assert_abs_diff_eq!(none, Correction { effort: 1.0 + 1e-9, ..none }, epsilon = 1e-8);
    assert!(!abs_diff_eq!(none, Correction { accepted: false, ..none }, epsilon = 1e9));
    let lanes = Correction::none(AutoF64x4::of(1.0));
    let other = Correction {
        accepted: AutoF64x4::from_lanes(|lane| lane as f64).above(AutoF64x4::of(0.0)),
        ..lanes
    };
    assert!(lanes == lanes && lanes != other);
}

/// Tolerances far below the digits of an `f64`.
#[test]
fn thirty_digits_have_tolerances_of_their_own() {
    let of = DoubleDouble::of;
    let (third, near) = (of(1.0) / of(3.0), of(1.0) / of(3.0) + of(1e-29));
    assert_abs_diff_eq!(third, near, epsilon = 2e-29);
    assert!(!abs_diff_eq!(third, near, epsilon = 0.5e-29));
    assert_relative_eq!(third, near, epsilon = 0.0, max_relative = 4e-29);
    assert!(!relative_eq!(third, near, epsilon = 0.0, max_relative = 2e-29));
    assert_ulps_eq!(third, near, epsilon = 0.0, max_ulps = 200);
    assert!(!ulps_eq!(third, near, epsilon = 0.0, max_ulps = 100));
    for odd in [f64::NAN, f64::INFINITY] {
        assert!(!relative_eq!(third, of(odd), epsilon = 1.0, max_relative = 1.0));
        assert!(!relative_eq!(of(odd), third, epsilon = 1.0, max_relative = 1.0));
    }
    let endless = of(f64::INFINITY);
    assert_abs_diff_eq!(endless, endless);
    assert_abs_diff_eq!(Vector1::new(third), Vector1::new(near), epsilon = 2e-29);
}
