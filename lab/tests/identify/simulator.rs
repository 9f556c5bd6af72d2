//! A log made by a simulator that nobody here wrote: scripts/mujoco_wall_log.py.

use approx::assert_relative_eq;
use lyapunov_lab::identify::{Settings, identify};
use lyapunov_lab::{Rollout, Scene};

const LOG: &str = include_str!("../../../scenes/logs/mujoco-wall.csv");

/// The script gives MuJoCo 0.3 kg, 0.201 N·s/m and 50 N/m, and closes a wall of 8 kN/m and 2 N·s/m around it.
#[test]
fn the_numbers_given_to_mujoco_are_found() {
    let found = identify(LOG.as_bytes(), "mujoco-wall.csv", &Settings::default()).unwrap();
    let report = &found.report;
    let wall = report.wall.unwrap();
    assert_relative_eq!(report.mass.value, 0.3, max_relative = 1e-6);
    assert_relative_eq!(report.damping.value, 0.201, max_relative = 1e-6);
    assert_relative_eq!(report.stiffness.value, 50.0, max_relative = 1e-6);
    assert!(report.rest.unwrap().value.abs() < 1e-9);
    assert_relative_eq!(wall.stiffness.value, 8000.0, max_relative = 1e-6);
    assert_relative_eq!(wall.damping.value, 2.0, max_relative = 1e-6);
    assert!(wall.position.value.abs() < 1e-9);
    assert_eq!((wall.late, report.acts_late, report.resolution), (0, 0, None));
}

/// The loop grows by a factor of 180 on the way, and errors with it.
#[test]
fn the_scene_runs_over_the_log() {
    let found = identify(LOG.as_bytes(), "mujoco-wall.csv", &Settings::default()).unwrap();
    let scene = Scene::parse(&found.scene, "found").unwrap();
    let rows = LOG.lines().skip(1).map(|line| {
        let mut fields = line.split(',').map(|field| field.parse::<f64>().unwrap());
        [fields.next().unwrap(), fields.next().unwrap(), fields.next().unwrap()]
    });
    let ticks = Rollout::<f64>::of(&scene).unwrap();
    let mut count = 0;
    for (tick, [time, position, force]) in ticks.zip(rows) {
        assert_relative_eq!(tick.time, time, epsilon = 1e-9);
        assert_relative_eq!(tick.truth.position, position, epsilon = 1e-6);
        assert_relative_eq!(tick.applied, force, epsilon = 1e-2);
        count += 1;
    }
    assert_eq!(count, 201);
}
