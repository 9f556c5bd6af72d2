//! Points of a body in an environment: the wrench is the slope of the energy, and each lane is its own.

use lyapunov::{
    OnePort, PortSample, Scalar, Signal,
    environments::{BodyPoints, Contact, ForceLaw, Kinematics, Plane, Sphere, Spring},
    lanes::AutoF64x4,
    poses::{Axes, BodyAxes, Pose, Screw, WithPose, WorldAxes},
};
use nalgebra::{SVector, Vector3};

use crate::support::{Dice, pose};

fn at<F: Axes>(pose: Pose<f64>) -> Kinematics<WithPose<f64, F>> {
    Kinematics::at(WithPose::at(pose), WithPose::default())
}

/// By central differences, in all six directions.
fn wrench_is_the_slope<L: ForceLaw<SVector<f64, 3>>, F: Axes>(law: L, points: [Vector3<f64>; 3]) {
    let mut dice = Dice::of(61);
    let tool = BodyPoints::of(law, points);
    let mut touched = 0;
    for _ in 0..1000 {
        let pose: Pose<f64> = dice.pose();
        let by = dice.screw::<f64, F>(1e-6, 1e-6);
        let stored = |by: Screw<f64, F>| tool.stored(&at::<F>(by.moving(&pose)));
        let slope = (stored(by) - stored(by.scale(-1.0))) / 2.0;
        let work = tool.force(&at::<F>(pose)).screw.inner(by);
        let size = 1e3 * 2.0 * 3e-6;
        assert!((slope - work).abs() < 1e-6 * size, "{slope:e} {work:e}");
        touched += usize::from(work != 0.0);
    }
    assert!(touched > 200, "{touched}");
}

#[test]
fn the_wrench_is_the_slope_of_the_energy() {
    let points =
        [Vector3::new(0.2, 0.1, -0.1), Vector3::new(-0.2, 0.0, 0.1), Vector3::new(0.0, 0.3, 0.0)];
    let spring = Spring::new(1e3).expect("a spring").at(Vector3::new(0.1, 0.2, 0.3));
    wrench_is_the_slope::<_, WorldAxes>(spring, points);
    wrench_is_the_slope::<_, BodyAxes>(spring, points);
    let floor = Plane::new(Vector3::zeros(), Vector3::new(0.3, 0.0, 1.0)).expect("a plane");
    let floor = Contact::with(floor, 1e3, 0.0).expect("a floor");
    wrench_is_the_slope::<_, WorldAxes>(floor, points);
    wrench_is_the_slope::<_, BodyAxes>(floor, points);
    let ball = Sphere::new(Vector3::zeros(), 0.8).expect("a ball");
    wrench_is_the_slope::<_, WorldAxes>(Contact::with(ball, 1e3, 0.0).expect("a ball"), points);
}

/// An edge against a wall, in closed form: the force at its depth, the torque at its arm, damping at its own speed.
#[test]
fn an_edge_meets_a_wall() {
    let floor = Plane::new(Vector3::zeros(), Vector3::z()).expect("a plane");
    let floor = Contact::with(floor, 1000.0, 5.0).expect("a floor");
    let edge = [Vector3::new(0.1, 0.05, -0.02), Vector3::new(0.1, -0.05, -0.02)];
    let mut tool = BodyPoints::of(floor, edge);
    let place = Pose::at(Vector3::new(0.0, 0.0, 0.017)); // 3 mm deep
    let twist = Screw::<f64>::new(Vector3::z() * -0.1, Vector3::y() * 2.0); // the edge sinks at 0.3 m/s
    let sample = PortSample::starting(1e-3, WithPose::at(place), WithPose::of(twist));
    let effort = tool.respond(&sample).screw;
    let push = 2.0 * (1000.0 * 0.003 + 5.0 * 0.3);
    assert!((effort.translation - Vector3::z() * -push).norm() < 1e-12);
    assert!((effort.rotation - Vector3::y() * (0.1 * push)).norm() < 1e-12);
}

/// Every lane is its own, to the bit.
#[test]
fn each_lane_is_its_own() {
    let mut dice = Dice::of(62);
    for _ in 0..200 {
        let numbers: [([f64; 3], [f64; 4], Screw<f64>); 4] = core::array::from_fn(|_| {
            let turn: Vector3<f64> = dice.vector(1.0);
            (
                [dice.within(0.2); 3],
                [turn.x, turn.y, turn.z, dice.within(1.0)],
                dice.screw(0.1, 1.0),
            )
        });
        let law = |dot: f64| {
            let normal = Vector3::new(0.0, dot, 1.0);
            let floor = Plane::new(Vector3::zeros(), normal).expect("a plane");
            BodyPoints::of(Contact::with(floor, 1e3, 2.0).expect("a floor"), [Vector3::x() * 0.1])
        };
        let together = {
            let wide = |value: f64| AutoF64x4::of(value);
            let all = |[x, y, z]: [f64; 3]| Vector3::new(wide(x), wide(y), wide(z));
            let normal = all([0.0, 0.3, 1.0]);
            let floor = Plane::new(all([0.0; 3]), normal).expect("a plane");
            let floor = Contact::with(floor, wide(1e3), wide(2.0)).expect("a floor");
            let mut tool = BodyPoints::of(floor, [all([0.1, 0.0, 0.0])]);
            let join = |of: &dyn Fn(usize) -> f64| AutoF64x4::from_lanes(of);
            let part = |of: &dyn Fn(usize, usize) -> f64| {
                Vector3::from_fn(|axis, _| join(&|lane| of(lane, axis)))
            };
            let position = part(&|lane, axis| numbers[lane].0[axis]);
            let turn = core::array::from_fn(|axis| join(&|lane| numbers[lane].1[axis]));
            let turn = nalgebra::Quaternion::from(nalgebra::Vector4::from(turn));
            let place = Pose::new(position, nalgebra::UnitQuaternion::new_unchecked(turn));
            let twist = Screw::<AutoF64x4>::new(
                part(&|lane, axis| numbers[lane].2.translation[axis]),
                part(&|lane, axis| numbers[lane].2.rotation[axis]),
            );
            let sample = PortSample::starting(wide(1e-3), WithPose::at(place), WithPose::of(twist));
            tool.respond(&sample).screw
        };
        for (lane, &(position, turn, twist)) in numbers.iter().enumerate() {
            let place = pose(Vector3::from(position), turn);
            let sample = PortSample::starting(1e-3, WithPose::at(place), WithPose::of(twist));
            let alone: Screw<f64> = law(0.3).respond(&sample).screw;
            let own = |part: Vector3<AutoF64x4>| Vector3::from_fn(|axis, _| part[axis].lane(lane));
            assert_eq!(own(together.translation), alone.translation);
            assert_eq!(own(together.rotation), alone.rotation);
        }
    }
}
