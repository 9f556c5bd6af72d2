//! Energies of dampers, friction and walls where a body sticks, slides, or moves for another time than the period.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use lyapunov_lab::Rollout;
use lyapunov_lab::explain::{Balance, Explanation};
use lyapunov_lab::scene::Scene;

use crate::bound::systems::scene;

/// A hand and a device of 0.3 kg, 10 mm from the rest of the hand and 11 mm from a wall of 1 kN/m with this `damping`.
fn pulled(rate: f64, damping: f64, more: &str) -> Scene {
    scene(&format!(
        "duration = 2\nservo_rate = {rate}\noperator = {{ mass = 0.1, damping = 4, stiffness = 200 }}\n\
         device = {{ mass = 0.2, damping = 2 }}\ninitial.position = -0.01\n\
         environment.wall = {{ position = 0.001, stiffness = 1000, damping = {damping} }}\n{more}"
    ))
}

fn explained(scene: &Scene) -> Balance {
    Explanation::of::<f64>(scene).unwrap().whole_run
}

#[test]
fn what_friction_holds_burns_nothing() {
    let held = pulled(100.0, 0.0, "effects.friction.coulomb = 3.0");
    let Balance { device, operator, friction, .. } = explained(&held);
    for burnt in [device, operator, friction] {
        assert_abs_diff_eq!(burnt, 0.0, epsilon = 1e-17);
    }
}

/// Friction burns its force times the way, whatever the rate; a tick in which the body turns hides a little of the way.
#[test]
fn friction_burns_its_force_over_the_way() {
    for (rate, coulomb, turned) in [(1000.0, 0.05, 1e-3), (100.0, 0.05, 1e-2), (100.0, 0.2, 1e-2)] {
        let scene = pulled(rate, 0.0, &format!("effects.friction.coulomb = {coulomb}"));
        let ticks = Rollout::<f64>::of(&scene).unwrap();
        let way: f64 = ticks.map(|tick| tick.truth.displacement.abs()).sum();
        let burnt = explained(&scene).friction;
        assert_relative_eq!(burnt, coulomb * way, max_relative = turned);
    }
}

/// The energy that a wall with a damper takes, against an integration over the same intervals by a program of its own.
#[test]
fn a_wall_takes_its_energy_over_the_time_that_the_plant_moves() {
    for (deviation, taken) in [(3e-4, 555.0e-6), (1e-4, 554.03e-6)] {
        let jitter = format!("effects.jitter = {{ deviation = {deviation}, seed = 5 }}");
        let scene = pulled(1000.0, 8.0, &jitter);
        assert_abs_diff_eq!(explained(&scene).wall, taken, epsilon = 0.05e-6);
    }
}
