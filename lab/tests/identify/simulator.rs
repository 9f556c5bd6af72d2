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

/// The script closes a wall of 1.5 kN/m and 4 N·s/m at 3 mm around 0.42 kg, 1.3 N·s/m and 180 N/m relaxed at 9 mm, through an
/// encoder of 20 µm, two rows late.
#[test]
fn an_encoder_and_a_delay_are_seen_through() {
    const LOG: &str = include_str!("../../../scenes/logs/mujoco-encoder.csv");
    let found = identify(LOG.as_bytes(), "mujoco-encoder.csv", &Settings::default()).unwrap();
    let report = &found.report;
    let wall = report.wall.unwrap();
    let numbers = [
        (report.mass, 0.42),
        (report.damping, 1.3),
        (report.stiffness, 180.0),
        (report.rest.unwrap(), 0.009),
        (wall.position, 0.003),
        (wall.stiffness, 1500.0),
        (wall.damping, 4.0),
    ];
    for (number, truth) in numbers {
        // Seven intervals at once hold the truth in fewer than 95 of 100 logs, so one log is judged by twice their width.
        let reach = number.high - number.low;
        assert!((number.value - truth).abs() <= reach, "{number:?}, {truth}");
        assert!(reach < 0.2 * truth, "{number:?}");
    }
    assert_eq!((report.acts_late, wall.late), (2, 0));
    assert_relative_eq!(report.resolution.unwrap(), 2e-5, max_relative = 1e-9);
    assert!(!report.residual.is_pushed, "{:?}", report.notes);
}
