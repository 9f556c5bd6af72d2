//! Serial arm: its Jacobian, its inertia and its motion against differences, another model and what it must keep.

use lyapunov::{
    Signal,
    integrators::{Integrator, Mechanics, RungeKutta4, State},
    models::{ArmLink, ControlAffine, RigidLink, SerialArm, TwoLinkArm},
    poses::{Pose, Screw},
};
use nalgebra::{Matrix3, SVector, UnitQuaternion, Vector2, Vector3, Vector4};

use crate::support::Dice;

use core::f64::consts::FRAC_PI_2;

pub(crate) type Joints = SVector<f64, 7>;

/// An arm with the kinematics of Franka's Panda (the maker's table) and made-up links.
pub(crate) fn panda() -> SerialArm<f64, 7> {
    let mut dice = Dice::of(81);
    let table = [
        [0.0, 0.0, 0.333],
        [0.0, -FRAC_PI_2, 0.0],
        [0.0, FRAC_PI_2, 0.316],
        [0.0825, FRAC_PI_2, 0.0],
        [-0.0825, -FRAC_PI_2, 0.384],
        [0.0, FRAC_PI_2, 0.0],
        [0.088, FRAC_PI_2, 0.0],
    ];
    let links = table.map(|[length, twist, offset]| {
        let some = Matrix3::from_fn(|_, _| dice.within(0.1));
        let inertia = some * some.transpose() + Matrix3::identity() * 5e-3;
        let centre = dice.vector(0.1);
        ArmLink { length, twist, offset, mass: 2.0 + dice.within(1.0), centre, inertia }
    });
    SerialArm::new(links, Pose::at(Vector3::z() * 0.107)).expect("an arm")
}

pub(crate) fn joints(dice: &mut Dice, size: f64) -> Joints {
    Joints::from_fn(|_, _| dice.within(size))
}

/// Stretched upwards the Panda's flange is 0.926 m high and 0.088 m ahead, and points down.
#[test]
fn it_stands_where_the_panda_stands() {
    let arm = panda();
    let stretched = arm.at(Joints::zeros());
    let tool = stretched.tool();
    assert!((tool.position - Vector3::new(0.088, 0.0, 0.926)).norm() < 1e-15);
    assert!((tool.to_world(Vector3::z()) + Vector3::z()).norm() < 1e-15);
}

#[test]
fn its_jacobian_is_the_slope_of_its_pose() {
    let (arm, mut dice) = (panda(), Dice::of(82));
    for _ in 0..200 {
        let (angles, by) = (joints(&mut dice, 3.0), joints(&mut dice, 1.0) * 1e-5);
        let (before, after) = (arm.at(angles - by), arm.at(angles + by));
        let moved = Screw::<f64>::between(before.tool(), after.tool());
        let apart = moved - arm.at(angles).jacobian().twist(by * 2.0);
        assert!(apart.translation.norm() < 1e-13 && apart.rotation.norm() < 1e-13, "{apart:?}");
    }
}

/// The inertia by composite bodies is that by the recursion of Newton and Euler, column by column.
#[test]
fn both_ways_to_the_inertia_agree() {
    let (arm, mut dice) = (panda(), Dice::of(83));
    for _ in 0..200 {
        let posture = arm.at(joints(&mut dice, 3.0));
        let inertia = posture.inertia();
        assert!((inertia - inertia.transpose()).norm() == 0.0);
        for column in 0..7 {
            let mut unit = Joints::zeros();
            unit[column] = 1.0;
            let torques = posture.torques(Joints::zeros(), unit);
            assert!((torques - inertia.column(column)).norm() < 1e-13);
        }
        let rates = joints(&mut dice, 2.0);
        assert!(rates.dot(&(inertia * rates)) > 0.0);
    }
}

/// Under torques it gains what they do, and free it keeps its energy, to the order of the integrator.
#[test]
fn it_keeps_its_energy() {
    let (arm, mut dice) = (panda(), Dice::of(84));
    let kinetic = |state: &State<Joints>| {
        0.5 * state.velocity.dot(&(arm.at(state.position).inertia() * state.velocity))
    };
    for _ in 0..3 {
        let mut state =
            State { position: joints(&mut dice, 3.0), velocity: joints(&mut dice, 2.0) };
        let start = kinetic(&state);
        for _ in 0..400 {
            state = state + RungeKutta4.step(&arm, state, Joints::zeros(), 5e-4);
        }
        assert!((kinetic(&state) / start - 1.0).abs() < 1e-8);

        let effort = joints(&mut dice, 5.0);
        let (before, from) = (kinetic(&state), state.position);
        for _ in 0..400 {
            state = state + RungeKutta4.step(&arm, state, effort, 5e-4);
        }
        let work = -effort.dot(&(state.position - from));
        assert!((kinetic(&state) - before - work).abs() < 1e-7 * (before + work.abs()));
    }
}

/// In a plane it is the arm of two links, which has equations of its own.
#[test]
fn in_a_plane_it_is_the_arm_of_two_links() {
    let (upper, lower) = (RigidLink::rod(2.0, 0.4), RigidLink::rod(1.0, 0.3));
    let known = TwoLinkArm::new(upper, lower).expect("an arm").horizontal();
    let link = |rod: RigidLink<f64>, before: f64| ArmLink {
        length: before,
        twist: 0.0,
        offset: 0.0,
        mass: rod.mass,
        centre: Vector3::x() * rod.centre,
        inertia: Matrix3::from_diagonal(&Vector3::new(1e-3, rod.inertia, rod.inertia)),
    };
    let tip = Pose::at(Vector3::x() * lower.length);
    let arm = SerialArm::new([link(upper, 0.0), link(lower, upper.length)], tip).expect("an arm");
    let mut dice = Dice::of(85);
    for _ in 0..500 {
        let mut two = |size| Vector2::new(dice.within(size), dice.within(size));
        let (angles, rates, torques) = (two(3.0), two(5.0), two(2.0));
        let state = Vector4::new(angles[0], angles[1], rates[0], rates[1]);
        let rate = ControlAffine::rate(&known, state, torques);
        let found = arm.acceleration(angles, rates, -torques);
        assert!((found - Vector2::new(rate[2], rate[3])).norm() < 1e-10);
        let reach = arm.at(angles).tool().position;
        let both = angles[0] + angles[1];
        let expected = Vector3::new(angles[0].cos(), angles[0].sin(), 0.0) * 0.4
            + Vector3::new(both.cos(), both.sin(), 0.0) * 0.3;
        assert!((reach - expected).norm() < 1e-15);
    }
}

#[test]
fn what_is_no_arm_is_refused() {
    let link = ArmLink {
        length: 0.0,
        twist: 0.0,
        offset: 0.0,
        mass: 1.0,
        centre: Vector3::x() * 0.1,
        inertia: Matrix3::zeros(),
    };
    let tool = Pose::at(Vector3::zeros());
    assert!(SerialArm::new([link], tool).is_ok());
    let refused = |link: ArmLink<f64>| SerialArm::new([link], tool).expect_err("refused").parameter;
    assert_eq!(refused(ArmLink { length: f64::NAN, ..link }), "length");
    assert_eq!(refused(ArmLink { twist: f64::INFINITY, ..link }), "twist");
    assert_eq!(refused(ArmLink { offset: f64::NAN, ..link }), "offset");
    assert_eq!(refused(ArmLink { mass: -1.0, ..link }), "mass");
    assert_eq!(refused(ArmLink { mass: 0.0, ..link }), "inertia's pivot");
    assert_eq!(refused(ArmLink { centre: Vector3::zeros(), ..link }), "inertia's pivot");
    let lost = Vector3::new(f64::NAN, 0.0, 0.0);
    assert_eq!(refused(ArmLink { centre: lost, ..link }), "centre or inertia");
    // A matrix from one triangle would not be the one whose entries make torques.
    let mut skew = Matrix3::identity();
    skew[(2, 0)] = 0.1;
    assert_eq!(refused(ArmLink { inertia: skew, ..link }), "inertia less its transpose");
    skew[(0, 2)] = 0.1;
    assert!(SerialArm::new([ArmLink { inertia: skew, ..link }], tool).is_ok());
    let held = |tool| SerialArm::new([link], tool).expect_err("refused").parameter;
    assert_eq!(held(Pose::at(lost)), "tool");
    let turned = |w: f64| {
        let quaternion = nalgebra::Quaternion::new(w, 0.0, 0.0, 0.0);
        Pose::new(Vector3::zeros(), UnitQuaternion::new_unchecked(quaternion))
    };
    assert_eq!(held(turned(f64::NAN)), "tool");
    assert_eq!([held(turned(0.0)), held(turned(1e200))], ["tool's orientation"; 2]);
    assert!(SerialArm::new([link], turned(2.0)).is_ok());
    let whole = lyapunov::models::ArmPosture::jacobian(
        &SerialArm::new([link], tool).expect("an arm").at(SVector::<f64, 1>::zeros()),
    );
    assert_eq!(whole.twist(SVector::<f64, 1>::new(2.0)).rotation, Vector3::z() * 2.0);
    assert_eq!(whole.torques(Screw::default()).inner(SVector::<f64, 1>::new(1.0)), 0.0);
}
