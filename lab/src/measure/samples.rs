//! Hand-made scenes for the tests of the meters.

use crate::files::Scene;

/// A second at 100 Hz before a wall of 1 kN/m and 2 N·s/m at 1 mm, starting 4 mm off a spring at rest at 0; `more` adds
/// keys or replaces these values.
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
