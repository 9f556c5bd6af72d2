//! Force and energy of each law: consistent, though neither is derived from the other.

use lyapunov::{
    Signal,
    bodies::Impedance,
    environments::{
        Contact, ForceLaw, HuntCrossley, Kinematics, LayeredWall, MassSpringDamper, MovingWall,
        Plane, Sphere, Spring, Surface, Time, VaryingSpring, Wall,
    },
};
use nalgebra::Vector2;

const TURN: f64 = 7.0;

/// A swing between 10 and 30 mm, with its derivatives.
pub(super) fn swing(t: f64) -> Kinematics<f64> {
    let (sine, cosine) = (TURN * t).sin_cos();
    Kinematics {
        time: Time::Seconds(t),
        position: 0.02 + 0.01 * sine,
        velocity: 0.01 * TURN * cosine,
        acceleration: -0.01 * TURN * TURN * sine,
    }
}

/// Checks `∫ f v dt = S(end) − S(start) + ∫ (dissipated + moved) dt` along `motion`, by Simpson's rule: `lost` is the
/// power, W, that a damper dissipates and that the mover of the environment takes.
pub(super) fn closes<V: Signal<Scalar = f64>>(
    law: &impl ForceLaw<V>,
    motion: impl Fn(f64) -> Kinematics<V>,
    lost: impl Fn(&Kinematics<V>) -> f64,
) {
    const STEPS: u32 = 20_000;
    let (end, mut work, mut size) = (1.3, 0.0, 0.0);
    for n in 0..=2 * STEPS {
        let at = motion(end * f64::from(n) / f64::from(2 * STEPS));
        let weight = match n {
            0 => 1.0,
            n if n == 2 * STEPS => 1.0,
            n if n % 2 == 1 => 4.0,
            _ => 2.0,
        };
        let share = weight * end / f64::from(6 * STEPS);
        let power = law.force(&at).inner(at.velocity);
        work += share * (power - lost(&at));
        size += share * power.abs();
    }
    let stored = law.stored(&motion(end)) - law.stored(&motion(0.0));
    assert!(size > 1e-3, "{size} J: nothing happens");
    assert!((work - stored).abs() <= 1e-8 * size, "{work} for {stored} of {size} J");
}

/// Checks that the energy at a place grows with the force at rest, `∂S/∂x = f`, from one side of the surface to the
/// other.
pub(super) fn slopes(law: &impl ForceLaw<f64>) {
    for t in [0.0, 0.013, 0.4] {
        for place in (-20..40).map(|n| 1e-3 * f64::from(n) + 0.37e-3) {
            let at =
                |position| Kinematics { time: Time::Seconds(t), ..Kinematics::at(position, 0.0) };
            let step = 1e-6;
            let rise = law.stored(&at(place + step)) - law.stored(&at(place - step));
            // At rest relative to a moving environment a damper pushes too: only springs are tested.
            let (slope, force) = (rise / (2.0 * step), law.force(&at(place)));
            assert!(
                (slope - force).abs() <= 1e-5 * (1.0 + force.abs()),
                "{slope} {force} at {place}"
            );
        }
    }
}

fn surface(law: &impl ForceLaw<f64>, at: &Kinematics<f64>) -> Surface<f64> {
    law.surface(at.time).expect("a surface")
}

#[test]
fn walls() {
    let wall = Wall::new(900.0, 2.0).expect("a wall").at(0.005);
    closes(&wall, swing, |at| 2.0 * at.velocity * at.velocity);
    slopes(&Wall::new(900.0, 0.0).expect("a wall").at(0.005));
    let layered =
        |damping| LayeredWall::new(0.01, [300.0, 4000.0], damping).expect("one").at(0.005);
    closes(&layered(1.0), swing, |at| at.velocity * at.velocity);
    slopes(&layered(0.0));
    let moving = |damping, amplitude| {
        let wall = Wall::new(900.0, damping).expect("a wall").at(0.003);
        MovingWall::new(wall, amplitude, 2.3, 1e3).expect("one")
    };
    let wall = moving(1.5, 0.002);
    closes(&wall, swing, |at| {
        let Surface { velocity, .. } = surface(&wall, at);
        let relative = at.velocity - velocity;
        1.5 * relative * relative + wall.force(at) * velocity
    });
    slopes(&moving(0.0, 0.002));
}

#[test]
fn the_surface_of_a_moving_wall_moves_at_its_own_speed() {
    let wall = MovingWall::new(Wall::new(900.0, 2.0).expect("a wall").at(0.003), 0.002, 2.3, 1e3);
    let wall = wall.expect("one");
    let at = |t: f64| -> Surface<f64> { wall.surface(Time::Seconds(t)).expect("a surface") };
    for t in [0.0, 0.1, 0.77] {
        let speed: f64 = (at(t + 1e-6).position - at(t - 1e-6).position) / 2e-6;
        assert!((speed - at(t).velocity).abs() < 1e-9, "{speed} at {t}");
        // Just outside of the surface no spring and no damper pushes, just inside both do.
        let near = |depth: f64| {
            let Surface { position, velocity } = at(t);
            let motion = Kinematics::at(position + depth, velocity + 0.1);
            wall.force(&Kinematics { time: Time::Seconds(t), ..motion })
        };
        assert_eq!(near(-1e-9), 0.0);
        assert!((near(1e-9) - 0.2).abs() < 1e-5);
    }
}

#[test]
fn hunt_and_crossley() {
    for exponent in [1.0, 1.5, 2.2] {
        let contact =
            |damping| HuntCrossley::new(3e4, exponent, damping).expect("a contact").at(0.005);
        closes(&contact(0.8), swing, |at| {
            3e4 * (at.position - 0.005).powf(exponent) * 0.8 * at.velocity * at.velocity
        });
        slopes(&contact(0.0));
    }
}

#[test]
fn springs() {
    let spring = Spring::new(400.0).expect("a spring").at(0.012);
    closes(&spring, swing, |_| 0.0);
    slopes(&spring);
    let parts = Impedance { mass: 0.4, damping: 1.2, stiffness: 300.0 };
    let body = MassSpringDamper::new(parts).expect("one").at(0.012);
    closes(&body, swing, |at| 1.2 * at.velocity * at.velocity);
    slopes(&MassSpringDamper::new(parts).expect("one"));
    let varying = VaryingSpring::new(spring, 90.0, 3.1, 1e3).expect("one");
    // The growing stiffness of the spring brings `k'(t) d² / 2`.
    let turn = core::f64::consts::TAU * 3.1;
    closes(&varying, swing, |at| {
        let away = at.position - 0.012;
        -0.5 * 90.0 * turn * (turn * at.time.seconds(0)).cos() * away * away
    });
    slopes(&varying);
}

#[test]
fn solids() {
    let round = |t: f64| {
        let (sine, cosine) = (TURN * t).sin_cos();
        Kinematics {
            time: Time::Seconds(t),
            position: Vector2::new(0.01 * cosine, 0.02 + 0.005 * sine),
            velocity: Vector2::new(-0.01 * TURN * sine, 0.005 * TURN * cosine),
            acceleration: Vector2::zeros(),
        }
    };
    let ball = Sphere::new(Vector2::zeros(), 0.05).expect("a ball");
    closes(&Contact::with(ball, 2000.0, 0.5).expect("one"), round, |at| {
        0.5 * (at.velocity.dot(&at.position) / at.position.norm()).powi(2)
    });
    let plane = Plane::new(Vector2::new(0.0, 0.05), Vector2::new(1.0, 3.0)).expect("a plane");
    let normal = Vector2::new(1.0, 3.0) / 10.0_f64.sqrt();
    closes(&Contact::with(plane, 2000.0, 0.5).expect("one"), round, |at| {
        0.5 * at.velocity.dot(&normal).powi(2)
    });
}
