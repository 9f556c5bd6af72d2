//! Signs of swings that are too fast for the ticks, or for the steps of an integrator.

use lyapunov_lab::Sign;

use crate::sanity::{of_run, press, shows};

#[test]
fn a_swing_faster_than_its_samples_is_told_with_the_one_that_they_see() {
    let hand = "{ mass = 0.1, damping = 2.0, stiffness = 100.0, motion = { kind = \"sine\", amplitude = 0.01, frequency = 1000.6 } }";
    let words = ["operator.motion.frequency is 1000.6 Hz", "as if it were 0.6 Hz"];
    shows(&of_run(&press(&[("operator", hand)])), Sign::Unit, &words);
    let wall = "{ moving-wall = { stiffness = 800.0, amplitude = 0.001, frequency = 700.0 } }";
    let words = ["environment.moving-wall.frequency", "300 Hz"];
    shows(&of_run(&press(&[("environment", wall)])), Sign::Unit, &words);
}

/// A step of 1 ms turns by `√(1e5 / 0.25) · 1e-3 = 0.632` rad.
#[test]
fn a_step_that_is_long_for_the_fastest_swing_is_told() {
    let told = |steps: &str| {
        let integrator = format!("2.0\nintegrator = \"rk4\"{steps}");
        let operator = "{ mass = 0.05, stiffness = 1e5 }";
        let device = "{ mass = 0.2 }";
        of_run(&press(&[("duration", &integrator), ("operator", operator), ("device", device)]))
    };
    shows(&told(""), Sign::Coarse, &["1 ms", "0.6325 rad"]);
    assert_eq!(told("\nsteps_per_tick = 2"), []);
}
