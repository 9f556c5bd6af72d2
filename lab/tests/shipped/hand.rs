//! The claims in the comments of the operator's scenes.

use approx::assert_abs_diff_eq;
use lyapunov_lab::{Rollout, Row};

use crate::shipped::rows::{between, least, most, rows, scene, width};

/// Position where a hand of 200 N/m at `rest` and a wall of 2 kN/m from 2 mm on balance.
fn pressed(rest: f64) -> f64 {
    (2000.0 * 0.002 + 200.0 * rest) / 2200.0
}

#[test]
fn link_buzzes_at_the_device_and_not_at_the_hand() {
    let ticks = Rollout::<f64>::of(&scene("link")).unwrap().filter(|tick| tick.time > 1.0);
    let (device, hand): (Vec<f64>, Vec<f64>) =
        ticks.map(|tick| (tick.truth.position, tick.operator.unwrap().position)).unzip();
    let width = |places: &[f64]| {
        let most = places.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        most - places.iter().copied().fold(f64::INFINITY, f64::min)
    };
    assert_abs_diff_eq!(width(&device) / width(&hand), 7.0, epsilon = 1.0);
}

#[test]
fn motion_step_bounces_four_times_and_rests() {
    let rows = rows("motion-step");
    assert!(between(&rows, 0.0, 0.499).iter().all(|row| row.x == 0.0));
    assert_abs_diff_eq!(most(&rows, |row| row.f_env), 5.6, epsilon = 0.05);
    let first = rows.iter().position(|row| row.x > 0.002).unwrap();
    let left = rows[first..].windows(2).filter(|pair| pair[0].x > 0.002 && pair[1].x <= 0.002);
    assert_eq!(left.count(), 4);
    assert_abs_diff_eq!(rows.last().unwrap().x, 2.5e-3, epsilon = 0.01e-3);
}

#[test]
fn motion_ramp_draws_the_line_of_the_wall() {
    let rows = rows("motion-ramp");
    let last = rows.last().unwrap();
    assert_abs_diff_eq!(last.f_env, 3.3, epsilon = 0.05);
    for row in between(&rows, 1.5, 3.0) {
        assert_abs_diff_eq!(row.f_env - 2000.0 * (row.x - 0.002), 0.0, epsilon = 0.1);
    }
    assert_abs_diff_eq!(last.x, pressed(0.02), epsilon = 1e-7);
}

#[test]
fn motion_sine_pushes_twice_a_second() {
    let rows = rows("motion-sine");
    let begins: Vec<f64> = rows
        .windows(2)
        .filter(|pair| pair[0].f_env == 0.0 && pair[1].f_env > 0.0)
        .map(|pair| pair[1].t)
        .collect();
    assert_eq!(begins.len(), 6, "{begins:?}");
    begins[1..]
        .windows(2)
        .for_each(|pair| assert_abs_diff_eq!(pair[1] - pair[0], 0.5, epsilon = 0.01));
    assert_abs_diff_eq!(most(&rows, |row| row.f_env), 10.0, epsilon = 0.5);
}

#[test]
fn motion_file_presses_waits_presses_deeper_and_lets_go() {
    let rows = rows("motion-file");
    let at = |t: f64| between(&rows, t, t + 1e-9)[0].x;
    assert_abs_diff_eq!(at(1.5), pressed(0.006), epsilon = 1e-6);
    assert_abs_diff_eq!(at(2.5), pressed(0.014), epsilon = 1e-6);
    assert!(at(3.9) < 0.0);
}

#[test]
fn grip_silences_the_wall_while_it_is_firm() {
    let rows = rows("grip");
    let swing = |from: f64| width(between(&rows, from, from + 0.5), |row: &Row| row.x);
    assert!(swing(0.5) > 5e-3 && swing(1.5) < 0.01e-3 && swing(2.5) > 5e-3);
    assert!(least(between(&rows, 1.5, 2.0), |row| row.f_env) > 0.0);
}
