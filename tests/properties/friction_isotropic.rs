//! Friction in a plane and in space against closed forms, the law on a line, and a fine integration.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use nalgebra::{Rotation2, SVector, Vector2, Vector3};

use lyapunov::{
    Plant,
    bodies::{Body, Friction, Impedance, IsotropicFriction, Stribeck},
};

use crate::friction::law;

fn puck<const N: usize>(
    [mass, damping, stiffness]: [f64; 3],
    period: f64,
    [position, velocity]: [SVector<f64, N>; 2],
    law: Stribeck<f64>,
) -> IsotropicFriction<f64, N> {
    let parts = Impedance { mass, damping, stiffness };
    let body = Body::new(parts, period).expect("a body").starting(position, velocity);
    IsotropicFriction::new(body, parts, law).expect("friction")
}

/// Under a steady force `f` and Coulomb friction `F`, with the angle `φ` between force and velocity, `m s' = f cos φ − F`
/// and `m s φ' = −f sin φ`. So `s sin φ / tan(φ/2)^(F/f)` stays, and `s (F + f cos φ)` falls by `(F² − f²) / m` a second.
#[test]
fn a_steady_force_turns_the_motion_by_two_closed_forms() {
    for (force, friction) in [(1.0, 1.7), (1.0, 1.0), (1.3, 0.4)] {
        let mass = 0.5;
        let start = Vector2::new(-0.3, 0.5);
        let law = law(friction, friction, 1.0);
        let mut puck = puck([mass, 0.0, 0.0], 0.01, [Vector2::zeros(), start], law);
        let kept = |velocity: Vector2<f64>| {
            let (speed, angle) = (velocity.norm(), velocity.y.atan2(velocity.x));
            let turned = speed * angle.sin() / (0.5 * angle).tan().powf(friction / force);
            (turned, speed * (friction + force * angle.cos()))
        };
        let (turned, falling) = kept(start);
        let slope = (friction * friction - force * force) / mass;
        for tick in 1..=15 {
            // Efforts act against the motion.
            let velocity = puck.advance(Vector2::new(-force, 0.0)).velocity;
            let (now, fallen) = kept(velocity);
            assert_relative_eq!(now, turned, max_relative = 1e-11);
            let due = falling - slope * 0.01 * f64::from(tick);
            assert_abs_diff_eq!(fallen, due, epsilon = 1e-12);
        }
    }
}

#[test]
fn it_stops_in_a_turn_at_the_instant_of_the_closed_form() {
    let (mass, force, friction) = (0.4, 0.9, 1.5);
    let start = Vector3::new(0.1, 0.3, -0.2);
    let along = start.x / start.norm();
    let stop =
        mass * start.norm() * (friction + force * along) / (friction * friction - force * force);
    let after = |interval: f64| {
        let law = law(friction, friction, 1.0);
        let mut puck = puck([mass, 0.0, 0.0], interval, [Vector3::zeros(), start], law);
        (puck.advance(Vector3::new(-force, 0.0, 0.0)), puck.heat())
    };
    let (before, _) = after(stop * (1.0 - 1e-9));
    assert!(before.velocity.norm() > 0.0);
    let (stopped, heat) = after(stop * (1.0 + 1e-9));
    assert_eq!(stopped.velocity, Vector3::zeros());
    // What it had and what the force gave has become heat.
    let had = 0.5 * mass * start.norm_squared() + force * stopped.displacement.x;
    assert_relative_eq!(heat, had, max_relative = 1e-12);
    // There it stays, to the bit.
    let law = law(friction, friction, 1.0);
    let mut stuck = puck([mass, 0.0, 0.0], 1e-3, [stopped.position, Vector3::zeros()], law);
    for _ in 0..100 {
        let sample = stuck.advance(Vector3::new(-force, 0.0, 0.0));
        assert_eq!(sample.position, stopped.position);
        assert_eq!((sample.velocity, stuck.heat()), (Vector3::zeros(), 0.0));
    }
}

/// Stick-slip of a pulled spring, a stop and a reversal along an axis, against the law on a line; then the same obliquely.
#[test]
fn on_a_line_it_is_the_law_on_a_line() {
    let parts = [0.3, 0.4, 200.0];
    let law = law(0.5, 0.9, 0.02);
    let effort = |tick: i32| 1.5 * (0.004 * f64::from(tick)).sin();
    let impedance = Impedance { mass: parts[0], damping: parts[1], stiffness: parts[2] };
    let body = Body::new(impedance, 1e-3).unwrap().starting(0.004_f64, -0.3);
    let mut line = Friction::new(body, impedance, law).unwrap();
    let axis = Vector2::new(0.0, 1.0);
    let mut along = puck(parts, 1e-3, [axis * 0.004, axis * -0.3], law);
    let turn = Rotation2::new(0.7) * axis;
    let mut oblique = puck(parts, 1e-3, [turn * 0.004, turn * -0.3], law);
    let (mut stuck, mut slid) = (0, 0);
    for tick in 0..2000 {
        let sample = line.advance(effort(tick));
        let same = along.advance(axis * effort(tick));
        assert_eq!([same.position.y, same.velocity.y], [sample.position, sample.velocity]);
        assert_eq!([same.position.x, same.velocity.x], [0.0, 0.0]);
        let turned = oblique.advance(turn * effort(tick));
        assert_abs_diff_eq!(turned.position, turn * sample.position, epsilon = 1e-12);
        assert_abs_diff_eq!(turned.velocity, turn * sample.velocity, epsilon = 1e-10);
        *(if sample.velocity == 0.0 { &mut stuck } else { &mut slid }) += 1;
    }
    assert_eq!(along.heat(), line.heat());
    assert!(stuck > 100 && slid > 100, "{stuck} {slid}");
}

/// The rates of deflection and velocity of a puck on a spring, written out.
fn rates(
    [mass, damping, stiffness]: [f64; 3],
    law: Stribeck<f64>,
    effort: Vector2<f64>,
    [position, velocity]: [Vector2<f64>; 2],
) -> [Vector2<f64>; 2] {
    let speed = velocity.norm();
    let fall = (-(speed / law.stribeck_velocity).powi(2)).exp();
    let friction = law.coulomb + (law.breakaway - law.coulomb) * fall;
    let force = -stiffness * position - damping * velocity - effort - friction * velocity / speed;
    [velocity, force / mass]
}

/// The end of a motion by the classical method of order 4 in `steps` equal steps.
fn integrated(
    parts: [f64; 3],
    law: Stribeck<f64>,
    effort: Vector2<f64>,
    start: [Vector2<f64>; 2],
    interval: f64,
    steps: usize,
) -> [Vector2<f64>; 2] {
    let h = interval / steps as f64;
    let mut state = start;
    for _ in 0..steps {
        let at = |by: f64, slope: [Vector2<f64>; 2]| {
            rates(parts, law, effort, [0, 1].map(|part| state[part] + by * slope[part]))
        };
        let first = rates(parts, law, effort, state);
        let second = at(0.5 * h, first);
        let third = at(0.5 * h, second);
        let fourth = at(h, third);
        state = [0, 1].map(|part| {
            let sum = first[part] + 2.0 * (second[part] + third[part]) + fourth[part];
            state[part] + h / 6.0 * sum
        });
    }
    state
}

#[test]
fn a_fine_integration_comes_to_the_same_end_at_its_own_order() {
    let (parts, law) = ([0.2, 0.6, 300.0], law(0.3, 0.8, 0.05));
    let start = [Vector2::new(0.004, -0.002), Vector2::new(0.1, 0.25)];
    let (effort, interval) = (Vector2::new(0.4, -1.1), 0.02);
    let mut puck = puck(parts, interval, start, law);
    let sample = puck.advance(effort);
    let error = |steps: usize| {
        let [position, velocity] = integrated(parts, law, effort, start, interval, steps);
        assert!(velocity.norm() > 0.01);
        ((position - sample.position).norm() * 40.0).hypot((velocity - sample.velocity).norm())
    };
    let errors = [100, 200, 400].map(error);
    // Sixteenfold from step to step: what is left is the error of the integration.
    assert_relative_eq!(errors[0] / errors[1], 16.0, max_relative = 0.1);
    assert_relative_eq!(errors[1] / errors[2], 16.0, max_relative = 0.1);
    assert!(error(6400) < 1e-13, "{}", error(6400));
}

/// A puck on a spring and no damper, thrown so that it circles: what it loses is heat, on every tick.
#[test]
fn energy_is_never_made_and_turning_the_axes_changes_nothing() {
    let (mass, stiffness) = (0.3, 150.0);
    let law = law(0.05, 0.08, 0.01);
    let start = [Vector2::new(0.02, 0.0), Vector2::new(0.1, 0.4)];
    let turn = Rotation2::new(1.1);
    let mut own = puck([mass, 0.0, stiffness], 1e-3, start, law);
    let mut turned = puck([mass, 0.0, stiffness], 1e-3, start.map(|part| turn * part), law);
    let stored = |position: Vector2<f64>, velocity: Vector2<f64>| {
        0.5 * stiffness * position.norm_squared() + 0.5 * mass * velocity.norm_squared()
    };
    let all = stored(start[0], start[1]);
    let mut before = 0.0;
    for _ in 0..6000 {
        let sample = own.advance(Vector2::zeros());
        assert!(own.heat() >= before);
        before = own.heat();
        assert_abs_diff_eq!(
            stored(sample.position, sample.velocity) + before,
            all,
            epsilon = 1e-14
        );
        let other = turned.advance(Vector2::zeros());
        assert_abs_diff_eq!(other.position, turn * sample.position, epsilon = 1e-12);
    }
    // It has come to rest off the spring's own rest, where static friction holds it.
    let held = own.body().start();
    assert_eq!(held.velocity, Vector2::zeros());
    assert!(stiffness * held.position.norm() <= law.breakaway);
}

#[test]
fn without_static_friction_it_is_the_body_and_bad_input_stays_bad_input() {
    let parts = Impedance { mass: 0.3, damping: 0.2, stiffness: 90.0 };
    let start = [Vector2::new(0.01, -0.02), Vector2::new(0.3, 0.1)];
    let mut bare = Body::new(parts, 1e-3).unwrap().starting(start[0], start[1]);
    let mut none = puck([0.3, 0.2, 90.0], 1e-3, start, law(0.0, 0.0, 0.01));
    for tick in 0..200 {
        let effort = Vector2::new(0.1, -0.2) * f64::from(tick % 5);
        let (own, bare) = (none.advance(effort), bare.advance(effort));
        assert_eq!((own.position, own.velocity), (bare.position, bare.velocity));
    }
    assert!(IsotropicFriction::new(bare, parts, law(2.0, 1.0, 0.01)).is_err());
    let mut lost = puck([0.3, 0.2, 90.0], 1e-3, start, law(0.1, 0.2, 0.01));
    assert!(lost.advance(Vector2::new(f64::NAN, 0.0)).velocity.x.is_nan());
    // Out of all proportion: it does not go on for ever, and takes no energy from nowhere.
    for effort in [1e300, 1e-300, -1e18] {
        let mut strange = puck([1e-9, 0.0, 1e12], 1.0, start, law(0.1, 1e6, 1e-9));
        strange.advance(Vector2::new(effort, 1.0));
        let heat = strange.heat();
        assert!(heat >= 0.0 || heat.is_nan(), "{effort}");
    }
}
