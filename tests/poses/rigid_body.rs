//! Rigid body: what it keeps, its balance, and its motion against closed forms.

use lyapunov::{
    Plant, Signal,
    bodies::{RigidBody, RigidParts},
    laws,
    poses::{Axes, BodyAxes, Pose, Screw, WithPose, WorldAxes},
};
use nalgebra::{Isometry3, Vector3};

use crate::support::{Dice, Real};

fn parts<T: Real>(damping: f64) -> RigidParts<T> {
    let [mass, one, two, three, turning] = [0.4, 1e-3, 2.5e-3, 3e-3, 1e-3 * damping].map(T::of);
    let moments = Vector3::new(one, two, three);
    RigidParts { mass, moments, damping: T::of(damping), rotational_damping: turning }
}

/// Momentum of rotation along the world's axes.
fn momentum(body: &RigidBody<f64>, moments: Vector3<f64>) -> Vector3<f64> {
    let rate = body.pose().to_body(body.twist().rotation);
    body.pose().to_world(moments.component_mul(&rate))
}

/// Free, it keeps its energy and the size of its momentum, however it tumbles and at any step.
fn keeps<T: Real>(tolerance: f64) {
    let mut dice = Dice::of(41);
    for period in [1e-4, 1e-3, 1e-2] {
        for _ in 0..5 {
            let spin = dice.screw::<T, WorldAxes>(0.5, 20.0);
            let body = RigidBody::<T>::new(parts(0.0), T::of(period), 1).expect("a body");
            let mut body = body.starting(dice.pose(), spin);
            let energy: f64 = body.kinetic().into();
            let mut most = 0.0f64;
            for _ in 0..5000 {
                body.advance(WithPose::default());
                most = most.max((Into::<f64>::into(body.kinetic()) / energy - 1.0).abs());
            }
            assert!(most < tolerance, "{period}: {most:e}");
        }
    }
}

/// The motion of a body whose moments are in the range, but no product of theirs, cannot be solved for.
#[test]
fn moments_whose_product_leaves_the_range_are_refused() {
    for size in [1e-18f32, 1e10, 1e11] {
        let parts = RigidParts { moments: Vector3::repeat(size), ..parts::<f32>(0.0) };
        let refused = RigidBody::<f32>::new(parts, 1e-3, 1).expect_err("no range").to_string();
        assert!(refused.starts_with("moment of inertia is "), "{refused}");
    }
    for size in [1e-9f32, 1e8] {
        let parts = RigidParts { moments: Vector3::repeat(size), ..parts::<f32>(0.0) };
        assert!(RigidBody::<f32>::new(parts, 1e-3, 1).is_ok(), "{size}");
    }
}

#[test]
fn a_free_body_keeps_its_energy() {
    keeps::<f64>(1e-12);
    keeps::<f32>(1e-3);
}

#[test]
fn a_free_body_keeps_its_momentum() {
    let mut body = RigidBody::<f64>::new(parts(0.0), 1e-3, 1).expect("a body");
    body = body.starting(
        Pose::at(Vector3::zeros()),
        Screw::new(Vector3::zeros(), Vector3::new(0.1, 9.0, 0.3)),
    );
    let (moments, before) = (parts(0.0).moments, momentum(&body, parts(0.0).moments));
    for _ in 0..20_000 {
        body.advance(WithPose::default());
        assert!((momentum(&body, moments).norm() - before.norm()).abs() < 1e-13);
    }
    // Its direction is that of a method of second order.
    assert!((momentum(&body, moments) - before).norm() < 1e-2 * before.norm());
}

/// What a held wrench takes is what the body loses, with the damper's share.
fn balances<F: Axes>(bound: f64) {
    let mut dice = Dice::of(42);
    for damping in [0.0, 0.8] {
        let parts = parts::<f64>(damping);
        let body = RigidBody::<f64, F>::new(parts, 1e-3, 1).expect("a body");
        let mut body = body.starting(dice.pose(), dice.screw(0.3, 10.0));
        let (mut balance, mut size) = (0.0f64, 0.0f64);
        for _ in 0..2000 {
            let (before, energy) = (body, body.kinetic());
            let sample = body.advance(WithPose::of(dice.screw(5.0, 0.2)));
            let moved = Screw::<f64, WorldAxes>::between(before.pose(), body.pose());
            let burnt = (parts.damping * moved.translation.norm_squared()
                + parts.rotational_damping * moved.rotation.norm_squared())
                / 1e-3;
            let lost = energy - body.kinetic();
            let work = sample.work.sum();
            balance += lost - work - burnt;
            size += lost.abs() + work.abs() + burnt;
        }
        assert!(balance.abs() < bound * size, "{balance:e} of {size:e}");
    }
}

#[test]
fn the_books_of_its_port_balance() {
    balances::<WorldAxes>(1e-10);
    // A force along the body's axes turns with the body; the rule holds it at the middle of the step.
    balances::<BodyAxes>(1e-5);
}

/// A symmetric top turns its spin about its own axis at `(I₃ − I₁) / I₁ ω₃`, in closed form; the error is of order 2.
#[test]
fn a_symmetric_top_precesses() {
    let moments = Vector3::new(1e-3, 1e-3, 1.8e-3);
    let parts = RigidParts { mass: 0.4, moments, damping: 0.0, rotational_damping: 0.0 };
    let start = Vector3::new(3.0, 0.0, 8.0);
    let rate = (moments.z - moments.x) / moments.x * start.z;
    let errors = [1, 2, 4].map(|steps| {
        let body = RigidBody::<f64, BodyAxes>::new(parts, 4e-3, steps).expect("a body");
        let mut body =
            body.starting(Pose::at(Vector3::zeros()), Screw::new(Vector3::zeros(), start));
        for _ in 0..250 {
            body.advance(WithPose::default());
        }
        let expected = Vector3::new(start.x * rate.cos(), start.x * rate.sin(), start.z);
        (body.twist().rotation - expected).norm()
    });
    assert!(errors[0] < 0.1, "{errors:?}");
    for pair in errors.windows(2) {
        assert!((pair[0] / pair[1] - 4.0).abs() < 0.05, "{errors:?}");
    }
}

/// A held force moves the centre of mass as it moves a point; a torque about a principal axis turns it so.
#[test]
fn it_falls_and_spins_up_as_it_should() {
    let mut body = RigidBody::<f64>::new(parts(0.0), 1e-3, 1).expect("a body");
    let wrench = Screw::new(Vector3::x() * -2.0, Vector3::z() * -6e-3);
    let mut sample = body.start();
    for _ in 0..500 {
        sample = body.advance(WithPose::of(wrench));
    }
    let (acceleration, turning) = (2.0 / 0.4, 6e-3 / 3e-3);
    let moved = sample.position.screw;
    assert!((moved.translation.x - 0.5 * acceleration * 0.25).abs() < 1e-12);
    assert!((moved.rotation.z - 0.5 * turning * 0.25).abs() < 1e-12);
    assert!((sample.velocity.screw.rotation.z - turning * 0.5).abs() < 1e-12);
}

/// A damped body slows by `exp(−b t / m)`.
#[test]
fn dampers_slow_it() {
    let parts = parts::<f64>(0.8);
    let spin = Screw::new(Vector3::x(), Vector3::z() * 3.0);
    let body = RigidBody::<f64>::new(parts, 1e-3, 10).expect("a body");
    let mut body = body.starting(Pose::at(Vector3::zeros()), spin);
    for _ in 0..400 {
        body.advance(WithPose::default());
    }
    let expected = |inertia: f64, damping: f64| (-damping * 0.4 / inertia).exp();
    assert!((body.twist().translation.x - expected(0.4, 0.8)).abs() < 1e-7);
    assert!((body.twist().rotation.z - 3.0 * expected(3e-3, 8e-4)).abs() < 1e-7);
}

#[test]
fn it_keeps_the_laws_of_a_plant() {
    let samples = || laws::Samples::<WithPose<f64>>::new(1e-3).take(450);
    let mut tame = samples().map(|(sample, effort)| (sample, effort.scale(1e-3)));
    let body = RigidBody::<f64>::new(parts(0.5), 1e-3, 2).expect("a body");
    laws::plant(&body, &mut tame).expect("the laws");
    let body = RigidBody::<f64, BodyAxes>::new(parts(0.5), 1e-3, 1).expect("a body");
    let samples = laws::Samples::<WithPose<f64, BodyAxes>>::new(1e-3).take(200);
    laws::plant(&body, samples.map(|(sample, effort)| (sample, effort.scale(1e-3)))).expect("laws");
}

/// A free body in `f32`, a decimetre from the origin and turned: each of a thousand short steps is far below what its pose can
/// tell.
#[test]
fn many_short_steps_lose_no_motion() {
    let start = Pose::from(Isometry3::new(Vector3::new(-0.1, 0.0, 0.0), Vector3::y()));
    let twist = Screw::new(Vector3::new(5e-3, 0.0, 0.0), Vector3::new(0.0, 0.05, 0.0));
    for steps in [1, 100, 1000] {
        let body = RigidBody::<f32>::new(parts(0.0), 1e-3, steps).expect("a body");
        let mut body = body.starting(start, twist);
        for _ in 0..1000 {
            body.advance(WithPose::default());
        }
        let moved = Screw::<f32, WorldAxes>::between(&start, body.pose());
        let [way, turn] = [moved.translation.x / 5e-3, moved.rotation.y / 0.05];
        assert!((way - 1.0).abs() < 1e-3 && (turn - 1.0).abs() < 1e-3, "{steps}: {way}, {turn}");
    }
}

#[test]
fn what_is_no_body_is_refused() {
    let sound = parts::<f64>(0.0);
    let refused = |parts, period, steps| {
        RigidBody::<f64>::new(parts, period, steps).expect_err("refused").to_string()
    };
    assert!(refused(RigidParts { mass: 0.0, ..sound }, 1e-3, 1).starts_with("mass is 0"));
    let flat = Vector3::new(1e-3, 0.0, 1e-3);
    assert!(
        refused(RigidParts { moments: flat, ..sound }, 1e-3, 1).starts_with("moment of inertia")
    );
    let needle = RigidParts { moments: Vector3::new(1.0, 1e-160, 1e-160), ..sound };
    assert!(refused(needle, 1e-3, 1).starts_with("moment of inertia is 1e-160"));
    assert!(refused(RigidParts { damping: -1.0, ..sound }, 1e-3, 1).starts_with("damping is -1"));
    let turning = RigidParts { rotational_damping: f64::NAN, ..sound };
    assert!(refused(turning, 1e-3, 1).starts_with("rotational damping"));
    assert!(refused(sound, 0.0, 1).starts_with("period"));
    assert!(refused(sound, 1e-3, 0).starts_with("steps"));
}
