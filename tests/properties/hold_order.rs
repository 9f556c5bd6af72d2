//! Hold then stabilize against stabilize then hold: energy that leaks before the observer sees it.

use approx::abs_diff_eq;
use lyapunov::{
    DampingLimit, Lolc, OnePort, Plant, PortEnergy, PortSample,
    bodies::{Body, Impedance},
    effects::OnePortExt,
    environments::Wall,
};

const PERIOD: f64 = 1e-3;
const MASS: f64 = 0.3;
const HOLD: u32 = 10;

/// Largest energy, J, that came out beyond what went in, for the hand and the device of `scenes/hold.toml` over its 2
/// s.
fn leaked(mut port: impl OnePort<f64>) -> f64 {
    let parts = Impedance { mass: MASS, damping: 2.1, stiffness: 200.0 };
    let mut body = Body::new(parts, PERIOD).expect("a body").resting_at(0.01);
    let (mut sample, mut taken, mut leaked): (PortSample<f64>, _, f64) = (body.start(), 0.0, 0.0);
    for _ in 0..=2000 {
        taken += sample.work;
        leaked = leaked.max(-taken);
        sample = body.advance(port.respond(&sample));
    }
    leaked
}

#[test]
fn a_stabilizer_outside_of_the_hold_lets_less_leak() {
    let wall = Wall::new(2000.0, 1.0).expect("a wall").at(0.002);
    let watcher = |period: f64| {
        Lolc::new(PortEnergy, DampingLimit::of_mass(0.5, MASS, period).expect("a limit"))
    };
    let alone = wall.held(HOLD).expect("a hold");
    let outside = alone.stabilized(watcher(PERIOD));
    let inside = wall.stabilized(watcher(f64::from(HOLD) * PERIOD)).held(HOLD).expect("a hold");
    // Results of a loop in straight code with the motion of a damped oscillator in closed form.
    let expected = [8.741734489739379e-4, 6.936653689831192e-3, 1.6869589816569712];
    let found =
        [leaked(outside.differenced()), leaked(inside.differenced()), leaked(alone.differenced())];
    for (found, expected) in found.into_iter().zip(expected) {
        assert!(
            abs_diff_eq!(found, expected, epsilon = 1e-9 * expected),
            "{found:e} for {expected:e}"
        );
    }
}
