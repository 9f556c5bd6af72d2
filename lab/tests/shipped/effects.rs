//! The claims in the comments of the effects' scenes.

use std::f64::consts::SQRT_2;

use approx::assert_abs_diff_eq;
use lyapunov_lab::{Rollout, Summary};

use crate::shipped::rows::{absorbed, between, edited, least, most, rows, rows_of, scene, width};

#[test]
fn hold_stands_still_for_ten_ticks_and_the_damping_does_not() {
    let rows = rows("hold");
    for (tick, pair) in (1..).zip(rows.windows(2)) {
        assert!(tick % 10 == 0 || pair[0].f_env == pair[1].f_env, "tick {tick}");
    }
    let answers =
        |of: usize| rows.iter().skip(of).step_by(10).filter(|row| row.alpha > 0.0).count();
    assert!((0..10).all(|of| answers(of) > 5));
}

#[test]
fn dropout_loses_three_in_ten_and_gives_energy() {
    let rows = rows("dropout");
    let contact: Vec<_> =
        rows.windows(2).filter(|pair| pair[0].x > 0.0021 && pair[1].x > 0.0021).collect();
    let lost = contact.iter().filter(|pair| pair[0].f_env == pair[1].f_env).count();
    assert_abs_diff_eq!(lost as f64 / contact.len() as f64, 0.3, epsilon = 0.04);
    assert_abs_diff_eq!(absorbed(&rows), -2.4e-3, epsilon = 0.05e-3);
}

#[test]
fn delay_makes_a_wall_that_settles_swing() {
    let scene = scene("delay");
    assert_abs_diff_eq!(most(&rows_of(&scene), |row| row.x.abs()), 0.033, epsilon = 0.0005);
    let prompt = edited(&scene, |draft| draft.effects.delay = None);
    let summary = Summary::of(&prompt, Rollout::<f64>::of(&prompt).unwrap());
    assert!(summary.settled.is_some_and(|time| time < 1.0), "{summary}");
}

#[test]
fn saturation_cuts_at_4_newton_and_lets_the_device_in() {
    let scene = scene("saturation");
    let cut = rows_of(&scene);
    assert_eq!(most(&cut, |row| row.f_out.abs()), 4.0);
    assert!(most(&cut, |row| row.f_env) > 20.0);
    let whole = edited(&scene, |draft| draft.effects.saturation = None);
    assert!(most(&cut, |row| row.x) > 1.2 * most(&rows_of(&whole), |row| row.x));
}

#[test]
fn filter_cutoff_makes_a_count_2_4_millimetres_per_second() {
    let scene = scene("filter-cutoff");
    let late = |rows: &[_]| most(between(rows, 1.0, 2.0), |row| row.v.abs());
    let turn = 2.0 * std::f64::consts::PI * 50.0 * 1e-3;
    let jump = turn / (1.0 + turn) * 1e-5 / 1e-3;
    assert_abs_diff_eq!(jump, 2.4e-3, epsilon = 0.05e-3);
    let filtered = late(&rows_of(&scene));
    assert!(filtered <= jump && filtered > 0.5 * jump, "{filtered}");
    let raw = edited(&scene, |draft| draft.effects.filter = None);
    assert_abs_diff_eq!(late(&rows_of(&raw)), 0.01, epsilon = 1e-9);
}

#[test]
fn filter_window_is_fine_when_slow_and_prompt_when_fast() {
    let rows = rows("filter-window");
    let slow = most(between(&rows, 1.0, 2.0), |row| row.v.abs());
    assert!(slow > 0.0 && slow < 0.7e-3, "{slow}");
    let true_peak = rows.windows(2).map(|pair| (pair[1].x - pair[0].x) * 1e3).fold(0.0, f64::max);
    assert_abs_diff_eq!(most(&rows, |row| row.v), true_peak, epsilon = 0.05 * true_peak);
}

#[test]
fn encoder_chatters_for_ever() {
    let rows = rows("encoder");
    for start in [0.5, 1.0, 1.5] {
        assert!(width(between(&rows, start, start + 0.5), |row| row.f_env) > 10.0);
    }
}

#[test]
fn noise_is_1_4_millimetres_per_second() {
    let rows = rows("noise");
    let late = between(&rows, 1.0, 2.0);
    let mean = late.iter().map(|row| row.v * row.v).sum::<f64>() / late.len() as f64;
    assert_abs_diff_eq!(mean.sqrt(), SQRT_2 * 1e-6 / 1e-3, epsilon = 0.1e-3);
    assert!(width(late, |row| row.x) < 2e-6);
}

#[test]
fn jitter_errs_where_the_motion_is_fast() {
    let rows = rows("jitter");
    let change = |chosen: fn(f64) -> bool| {
        let pairs = rows.windows(2).skip(500).filter(|pair| chosen(pair[1].v.abs()));
        let squares: Vec<f64> = pairs.map(|pair| (pair[1].v - pair[0].v).powi(2)).collect();
        (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
    };
    let fastest = most(&rows[500..], |row| row.v.abs());
    let (fast, turning) = (change(|v| v > 0.3), change(|v| v < 0.1));
    // The change from tick to tick has the errors of two intervals; where the motion turns, it is mostly acceleration.
    assert_abs_diff_eq!(fast / SQRT_2 / fastest, 0.05, epsilon = 0.01);
    assert!(turning < fast / 3.0, "{turning} for {fast}");
}

#[test]
fn friction_sticks_to_1_newton_and_slips_seven_times() {
    let rows = rows("friction");
    let rest = |t: f64| 0.01 * t;
    let mut slips = 0;
    for three in rows.windows(3) {
        let [before, at, after] = three else { continue };
        if before.x == at.x && after.x != at.x {
            assert_abs_diff_eq!(200.0 * (rest(at.t) - at.x), 1.0, epsilon = 0.01);
            slips += 1;
        }
    }
    assert_eq!(slips, 7);
}

#[test]
fn load_rests_where_three_forces_balance() {
    assert_abs_diff_eq!(
        rows("load").last().unwrap().x,
        (2000.0 * 0.002 + 2.0) / 2200.0,
        epsilon = 1e-8
    );
    assert_abs_diff_eq!(2.73e-3, (2000.0 * 0.002 + 2.0) / 2200.0, epsilon = 0.005e-3);
}

#[test]
fn pulse_goes_2_9_millimetres_deeper_and_off_the_wall() {
    let rows = rows("pulse");
    let (rest, after) = (between(&rows, 0.9, 1.0), between(&rows, 1.0, 2.0));
    assert_abs_diff_eq!(
        most(after, |row| row.x) - most(rest, |row| row.x),
        2.9e-3,
        epsilon = 0.05e-3
    );
    assert!(least(rest, |row| row.x) > 0.0025 && least(after, |row| row.x) < 0.002);
    assert!(width(between(&rows, 1.8, 2.0), |row| row.x) < 0.05e-3);
}

#[test]
fn the_tour_works_all_its_parts() {
    let scene = scene("tour");
    let effects = &scene.effects;
    let has = [
        effects.encoder.is_some(),
        effects.noise.is_some(),
        effects.filter.is_some(),
        effects.delay.is_some(),
        effects.saturation.is_some(),
        effects.friction.is_some(),
        effects.jitter.is_some(),
        effects.dropout.is_some(),
        effects.pulse.is_some(),
        scene.link.is_some(),
        scene.operator.motion.is_some(),
    ];
    assert!(has.iter().all(|has| *has));
    let rows = rows_of(&scene);
    assert!(
        rows.iter().any(|row| row.alpha > 0.0) && least(&rows, |row| row.observed_energy) < 0.0
    );
    for second in 0..4 {
        let stroke = between(&rows, second.into(), f64::from(second) + 1.0);
        assert!(most(stroke, |row| row.f_env) > 1.0 && least(stroke, |row| row.x) < -0.01);
    }
    // The loop with all its parts is bounded.
    assert!(most(&rows, |row| row.x.abs()) < 0.03);
}
