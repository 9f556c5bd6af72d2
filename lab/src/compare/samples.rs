//! Hand-made rows and scenes for the tests of the meters.

use super::tick::Tick;
use crate::{Row, Scene};

/// A row in which nothing happens.
pub(super) fn row() -> Row {
    Row {
        t: 0.0,
        x: 0.0,
        x_measured: 0.0,
        v: 0.0,
        f_env: 0.0,
        f_ctl: 0.0,
        f_out: 0.0,
        f_act: 0.0,
        observer: 0.0,
        alpha: 0.0,
        shortfall: 0.0,
        accepted: true,
    }
}

/// A tick on which the plant is at `x`, `environment` of the force is the wall's and `controller` not.
pub(super) fn tick(x: f64, environment: f64, controller: f64) -> Tick {
    let f_act = environment + controller;
    Tick { row: Row { x, f_env: environment, f_act, ..row() }, velocity: 0.0, environment }
}

/// A second at 100 Hz before a wall of 1 kN/m and 2 N·s/m at 1 mm, starting 4 mm off a spring at rest at 0;
/// with more keys, or other values of these.
pub(crate) fn scene(more: &str) -> Scene {
    let usual = [
        ("duration", "1.0"),
        ("servo_rate", "100.0"),
        ("device.mass", "0.3"),
        ("operator.stiffness", "50.0"),
        ("initial.position", "-0.004"),
        ("environment.wall.position", "0.001"),
        ("environment.wall.stiffness", "1000.0"),
        ("environment.wall.damping", "2.0"),
    ];
    let given = |key: &str| more.lines().any(|line| line.starts_with(key));
    let usual = usual.iter().filter(|(key, _)| !given(key));
    let text: String = usual.map(|(key, value)| format!("{key} = {value}\n")).collect();
    Scene::parse(&format!("{text}{more}"), "test").unwrap()
}
