//! Refusal of invalid parameters of environments, by name.

use lyapunov::{
    ParameterError,
    bodies::Impedance,
    environments::{
        Contact, CubicSpring, Cuboid, HuntCrossley, LayeredWall, MassSpringDamper, MovingWall,
        Plane, Sphere, Spring, VaryingSpring, Wall,
    },
};
use nalgebra::{Vector2, Vector3};

/// Checks that each value is refused, and under this name.
fn refused<B>(name: &str, values: &[f64], build: impl Fn(f64) -> Result<B, ParameterError>) {
    for value in values {
        match build(*value) {
            Ok(_) => panic!("{name} may be {value}"),
            Err(error) => {
                assert_eq!(error.parameter, name);
                assert!(error.value == *value || value.is_nan() && error.value.is_nan(), "{error}");
            }
        }
    }
}

const NOT_FINITE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
const BELOW: [f64; 4] = [f64::NAN, f64::INFINITY, -1.0, -5e-324];
const NOT_ABOVE: [f64; 5] = [f64::NAN, f64::INFINITY, -1.0, 0.0, -0.0];

#[test]
fn walls() {
    refused("depth", &BELOW, |x| LayeredWall::new(x, [1.0, 2.0], 1.0));
    refused("stiffness", &BELOW, |x| LayeredWall::new(1.0, [x, 2.0], 1.0));
    refused("stiffness", &BELOW, |x| LayeredWall::new(1.0, [1.0, x], 1.0));
    refused("damping", &BELOW, |x| LayeredWall::new(1.0, [1.0, 2.0], x));
    refused("stiffness", &BELOW, |x| HuntCrossley::new(x, 1.5, 1.0));
    refused("exponent", &NOT_ABOVE, |x| HuntCrossley::new(1.0, x, 1.0));
    refused("damping", &BELOW, |x| HuntCrossley::new(1.0, 1.5, x));
    refused("stiffness", &BELOW, |x| CubicSpring::<f64>::new(x, 1.0));
    refused("cubic", &BELOW, |x| CubicSpring::<f64>::new(1.0, x));
    assert!(LayeredWall::new(0.0, [0.0, 0.0], 0.0).is_ok());
    assert!(HuntCrossley::new(0.0, 1.0, 0.0).is_ok());
}

#[test]
fn oscillating_environments() {
    let wall = Wall::new(1.0, 1.0).expect("a wall");
    let moving = MovingWall::new(wall, 1.0, 1.0, 1.0).expect("a moving wall");
    refused("amplitude", &NOT_FINITE, |x| MovingWall::new(wall, x, 1.0, 1.0));
    refused("frequency", &BELOW, |x| MovingWall::new(wall, 1.0, x, 1.0));
    refused("rate", &NOT_ABOVE, |x| MovingWall::new(wall, 1.0, 1.0, x));
    refused("rate", &NOT_ABOVE, |x| moving.dissipation(x));
    let spring = || Spring::<f64>::new(1.0).expect("a spring");
    refused("amplitude", &NOT_FINITE, |x| VaryingSpring::new(spring(), x, 1.0, 1.0));
    refused("frequency", &BELOW, |x| VaryingSpring::new(spring(), 1.0, x, 1.0));
    refused("rate", &NOT_ABOVE, |x| VaryingSpring::new(spring(), 1.0, 1.0, x));
    // A phase or a speed out of the range of numbers.
    refused("frequency", &[1e300], |x| MovingWall::new(wall, 1.0, x, 1.0));
    refused("frequency", &[1e10], |x| MovingWall::new(wall, 1e299, x, 1.0));
    let narrow = Wall::new(1.0_f32, 1.0).expect("a wall");
    assert!(MovingWall::new(narrow, 1e30, 1e10, 1.0).is_err());
    assert!(MovingWall::new(wall, -1.0, 0.0, 1.0).is_ok());
}

#[test]
fn the_mass_spring_damper() {
    let build = |mass, damping, stiffness| {
        MassSpringDamper::<f64>::new(Impedance { mass, damping, stiffness })
    };
    refused("mass", &NOT_FINITE, |x| build(x, 1.0, 1.0));
    refused("damping", &NOT_FINITE, |x| build(1.0, x, 1.0));
    refused("stiffness", &NOT_FINITE, |x| build(1.0, 1.0, x));
}

#[test]
fn solids() {
    let up = Vector2::new(0.0, 1.0);
    refused("point", &NOT_FINITE, |x| Plane::new(Vector2::new(0.0, x), up));
    refused("normal", &NOT_FINITE, |x| Plane::new(up, Vector2::new(x, 1.0)));
    refused("normal", &[0.0], |x| Plane::new(up, Vector2::new(x, -x)));
    refused("center", &NOT_FINITE, |x| Sphere::new(Vector3::new(0.0, 0.0, x), 1.0));
    refused("radius", &NOT_ABOVE, |x| Sphere::new(Vector3::zeros(), x));
    refused("center", &NOT_FINITE, |x| Cuboid::new(Vector2::new(x, 0.0), up + up.yx()));
    refused("half", &NOT_ABOVE, |x| Cuboid::new(up, Vector2::new(1.0, x)));
    let plane = Plane::new(up, up).expect("a plane");
    refused("stiffness", &BELOW, |x| Contact::with(plane, x, 1.0));
    refused("damping", &BELOW, |x| Contact::with(plane, 1.0, x));
    assert!(Contact::with(plane, 0.0, 0.0).is_ok());
}
