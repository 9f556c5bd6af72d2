//! Orientation spring: the torque is the slope of the energy.

use lyapunov::{
    LyapunovCandidate, OnePort, Plant, PortSample, Signal,
    bodies::{RigidBody, RigidParts},
    environments::{ForceLaw, Kinematics, OrientationSpring},
    laws,
    poses::{Axes, BodyAxes, Pose, Screw, WithPose, WorldAxes},
};
use nalgebra::{Isometry3, Vector3};

use crate::support::Dice;

fn at<F: Axes>(pose: Pose<f64>) -> Kinematics<WithPose<f64, F>> {
    Kinematics::at(WithPose::at(pose), WithPose::default())
}

/// By central differences along every small displacement.
fn torque_is_the_slope<F: Axes>() {
    let mut dice = Dice::of(51);
    for _ in 0..500 {
        let (rest, pose): (Pose<f64>, Pose<f64>) = (dice.pose(), dice.pose());
        if Screw::<f64>::between(&rest, &pose).rotation.norm() > 3.1 {
            continue;
        }
        let spring = OrientationSpring::new(2.5, 0.0).expect("a spring").at(rest);
        let by = Screw::<f64, F>::new(Vector3::zeros(), dice.direction() * 1e-5);
        let stored = |by: Screw<f64, F>| spring.stored(&at::<F>(by.moving(&pose)));
        let slope = (stored(by) - stored(by.scale(-1.0))) / 2.0;
        let work = spring.force(&at::<F>(pose)).screw.inner(by);
        assert!((slope - work).abs() < 1e-9 * 2.5 * 1e-5 + 1e-13, "{slope:e} {work:e}");
        assert_eq!(spring.force(&at::<F>(pose)).screw.translation, Vector3::zeros());
    }
}

#[test]
fn its_torque_is_the_slope_of_its_energy() {
    torque_is_the_slope::<WorldAxes>();
    torque_is_the_slope::<BodyAxes>();
}

/// Through half a turn the energy is continuous and largest, and the torque changes sign.
#[test]
fn at_half_a_turn_it_gives_way() {
    let spring = OrientationSpring::new(2.0, 0.0).expect("a spring");
    let turned =
        |angle: f64| at::<WorldAxes>(Pose::from(Isometry3::rotation(Vector3::x() * angle)));
    let half = core::f64::consts::PI;
    for apart in [1e-3, 1e-6, 1e-9] {
        let (before, after) = (turned(half - apart), turned(half + apart));
        assert!((spring.stored(&before) - spring.stored(&after)).abs() < 1e-13);
        assert!((spring.stored(&before) - half * half).abs() < 2.0 * half * apart + 1e-13);
        let torque = |motion| spring.force(&motion).screw.rotation.x;
        assert!((torque(before) - 2.0 * (half - apart)).abs() < 1e-13);
        assert!((torque(after) + 2.0 * (half - apart)).abs() < 1e-13);
    }
}

/// A ball on it swings at `√(k / I)`, whatever the axis; with a damper it decays as it should.
#[test]
fn a_ball_on_it_swings() {
    let (stiffness, moment, period): (f64, f64, f64) = (2.0, 2e-3, 1e-4);
    let parts = RigidParts {
        mass: 1.0,
        moments: Vector3::from_element(moment),
        damping: 0.0,
        rotational_damping: 0.0,
    };
    let axis = Vector3::new(1.0, 2.0, -2.0) / 3.0;
    for damping in [0.0, 0.01] {
        let mut port = OrientationSpring::new(stiffness, damping).expect("a spring");
        let start = Pose::from(Isometry3::rotation(axis * 0.5));
        let body = RigidBody::<f64>::new(parts, period, 1).expect("a body");
        let mut body = body.starting(start, Screw::default());
        let mut sample = body.start();
        let decay: f64 = damping / (2.0 * moment);
        let rate = (stiffness / moment - decay * decay).sqrt();
        for tick in 1..=3000 {
            sample = body.advance(port.respond(&sample));
            let time = f64::from(tick) * period;
            let (sine, cosine) = (rate * time).sin_cos();
            let expected = 0.5 * (-decay * time).exp() * (cosine + decay / rate * sine);
            let found = Screw::<f64>::between(&Pose::at(Vector3::zeros()), body.pose()).rotation;
            assert!((found - axis * expected).norm() < 0.02, "tick {tick}: {found} {expected}");
        }
    }
}

#[test]
fn its_damper_is_credited() {
    let spring = OrientationSpring::new(2.0, 0.1).expect("a spring");
    let twist = WithPose::of(Screw::<f64>::new(Vector3::x(), Vector3::new(0.0, 3.0, 4.0)));
    let sample = PortSample::starting(1e-3, WithPose::at(Pose::at(Vector3::zeros())), twist);
    assert!((spring.dissipation().decrease(&sample) - 0.1 * 25.0 * 1e-3).abs() < 1e-15);
    assert_eq!({ spring }.respond(&sample).screw.rotation, Vector3::new(0.0, 3.0, 4.0) * 0.1);
    let wild = WithPose::of(Screw::<f64>::splat(f64::INFINITY));
    assert_eq!(spring.dissipation().decrease(&PortSample { velocity: wild, ..sample }), 0.0);
}

#[test]
fn it_keeps_the_laws_and_refuses_what_is_no_spring() {
    let spring = OrientationSpring::new(2.0, 0.1).expect("a spring");
    let mut dice = Dice::of(52);
    let samples = laws::Samples::<WithPose<f64>>::new(1e-3).map(|(sample, effort)| {
        let position = WithPose { pose: dice.pose(), ..sample.position };
        (PortSample { position, ..sample }, effort)
    });
    laws::one_port(&spring, samples).expect("the laws");
    for (stiffness, damping) in [(-1.0, 0.0), (1.0, -1.0), (f64::NAN, 0.0), (1.0, f64::INFINITY)] {
        assert!(OrientationSpring::new(stiffness, damping).is_err());
    }
}
