//! The claims in the comments of the environments' scenes.

use std::f64::consts::PI;

use approx::assert_abs_diff_eq;
use lyapunov_lab::scene::{Draft, Environment, Finite};

use crate::shipped::rows::{between, edited, least, most, rows, rows_of, scene, ticks_in_space};

#[test]
fn spring_that_pushes_away_leaves_50_newton_per_metre() {
    assert_abs_diff_eq!(rows("spring").last().unwrap().x, 4.0 * 0.002, epsilon = 0.01e-3);
}

#[test]
fn mass_spring_damper_swings_with_both_masses() {
    let rows = rows("mass-spring-damper");
    let falls: Vec<f64> = rows
        .windows(2)
        .filter(|pair| pair[0].x > 0.0 && pair[1].x <= 0.0)
        .map(|pair| pair[1].t)
        .collect();
    let turns = falls.len() - 1;
    let period = (falls[turns] - falls[0]) / turns as f64;
    assert_abs_diff_eq!(period, 2.0 * PI * (0.4_f64 / 250.0).sqrt(), epsilon = 0.5e-3);
    assert_abs_diff_eq!(0.218, 2.0 * PI * (0.3_f64 / 250.0).sqrt(), epsilon = 0.5e-3);
}

#[test]
fn layered_wall_is_forty_times_as_stiff_below() {
    let rows = rows("layered-wall");
    let spring = |x: f64| match x - 0.002 {
        ..0.0 => 0.0,
        p @ ..0.003 => 500.0 * p,
        p => 1.5 + 20_000.0 * (p - 0.003),
    };
    for row in rows.iter().filter(|row| row.x > 0.002) {
        assert_abs_diff_eq!(row.f_env, (spring(row.x) + 20.0 * row.v).max(0.0), epsilon = 1e-9);
    }
    let bone = between(&rows, 2.9, 3.0);
    assert!(bone[0].x > 0.0053 && bone[0].f_env > 8.0);
    assert!(rows.iter().any(|row| row.x > 0.004 && row.f_env < 2.0));
}

#[test]
fn hunt_crossley_takes_a_share_that_falls_with_speed() {
    let scene = scene("hunt-crossley");
    let back = -rows_of(&scene).last().unwrap().v;
    assert_abs_diff_eq!(back, 0.179, epsilon = 0.5e-3);
    // From the law with v dv = -F dp / m: g(v) = v / d - ln(1 + d v) / d^2 is the same before and after.
    let g = |v: f64| v - v.ln_1p();
    let (mut low, mut high) = (0.0, 0.2);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if g(-middle) < g(0.2) { low = middle } else { high = middle }
    }
    // The sampled force gives a little energy back.
    assert_abs_diff_eq!(back, low, epsilon = 0.02 * low);
    let slower = |draft: &mut Draft| draft.initial.velocity = Finite::new(0.1).unwrap().into();
    let slower = -rows_of(&edited(&scene, slower)).last().unwrap().v;
    assert!(slower / 0.1 > back / 0.2 + 0.02, "{slower}");
}

#[test]
fn moving_wall_works_on_the_hand() {
    let rows = rows("moving-wall");
    let observer = |t: f64| between(&rows, t, t + 1e-9)[0].observed_energy;
    assert_abs_diff_eq!(observer(3.0) - observer(2.0), -2.6e-3, epsilon = 0.05e-3);
    assert!(rows.iter().all(|row| row.alpha == 0.0));
}

#[test]
fn varying_spring_swings_itself_up() {
    let scene = scene("varying-spring");
    assert!(most(&rows_of(&scene), |row| row.x.abs()) > 100.0 * 0.001);
    let steady = edited(&scene, |draft| {
        if let Environment::VaryingSpring(spring) = &mut draft.environment {
            spring.amplitude = Finite::new(0.0).unwrap();
        }
    });
    assert!(most(&rows_of(&steady), |row| row.x.abs()) < 1.01 * 0.001);
}

/// A held spring gives `T / 2 f'(x) v²` and the dampers take `b v²`: along an undamped swing of size A both are equal
/// where the mean of `f' = k + 3 c x²`, weighted with the velocity, is `2 b / T`.
#[test]
fn cubic_spring_lets_small_swings_die_and_large_ones_grow() {
    let mean = |size: f64| {
        let stored = |x: f64| 100.0 * x * x + 0.25e6 * x.powi(4);
        let places = (0..10_000).map(|n| size * (f64::from(n) + 0.5) / 1e4);
        let speeds = places.map(|x| (x, (stored(size) - stored(x)).sqrt()));
        let (sum, weight) = speeds.fold((0.0, 0.0), |(sum, weight), (x, speed)| {
            (sum + speed * (200.0 + 3e6 * x * x), weight + speed)
        });
        sum / weight
    };
    let grows = |size: f64| {
        let start = |draft: &mut Draft| draft.initial.position = Finite::new(-size).unwrap().into();
        let scene = edited(&scene("cubic-spring"), start);
        let rows = rows_of(&scene);
        let of = |from, to| most(between(&rows, from, to), |row| row.x.abs());
        of(1.5, 2.0) > of(0.0, 0.5)
    };
    assert!(grows(0.025) && !grows(0.015));
    let (mut low, mut high) = (0.015, 0.025);
    while high - low > 1e-6 {
        let middle = 0.5 * (low + high);
        if mean(middle) > 2.0 * 0.3 / 1e-3 { high = middle } else { low = middle }
    }
    assert!(grows(1.03 * low) && !grows(0.97 * low), "{low}");
}

#[test]
fn plane_pushes_square_to_itself_and_lets_slide() {
    let ticks = ticks_in_space::<2>("plane");
    for tick in &ticks {
        assert_abs_diff_eq!(tick.environment.y, 2.0 * tick.environment.x, epsilon = 1e-12);
    }
    let late = ticks.iter().filter(|tick| tick.time > 1.0);
    let (least, most) = late
        .map(|tick| tick.truth.position.x)
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
    assert!(most - least > 0.03);
    // Penetration depth along the wall's normal.
    let depth = |x: f64, y: f64| -(0.5 * x + y) / 1.25_f64.sqrt();
    let places = ticks.iter().map(|tick| tick.truth.position);
    let deepest = places.map(|place| depth(place.x, place.y)).fold(0.0, f64::max);
    assert!(deepest > 0.0 && deepest < 3e-3, "{deepest}");
}

#[test]
fn sphere_is_slid_over() {
    let places = ticks_in_space::<3>("sphere").into_iter().map(|tick| tick.truth.position);
    let places: Vec<_> = places.collect();
    let nearest = places.iter().map(|place| place.norm()).fold(f64::INFINITY, f64::min);
    assert_abs_diff_eq!(nearest, 18.8e-3, epsilon = 0.1e-3);
    let crossings = places.windows(2).filter(|pair| pair[0].x * pair[1].x <= 0.0);
    let over: Vec<f64> = crossings.map(|pair| pair[1].z).collect();
    assert!(over.len() >= 3 && over[1..].iter().all(|z| *z > 0.019), "{over:?}");
}

#[test]
fn box_pushes_with_one_face() {
    for tick in ticks_in_space::<2>("box").iter().filter(|tick| tick.time > 1.0) {
        assert_abs_diff_eq!(tick.environment.x.abs(), 1.9, epsilon = 0.1);
        assert_eq!(tick.environment.y, 0.0);
    }
}

#[test]
fn walls_on_a_line_only_push() {
    for name in ["layered-wall", "hunt-crossley", "moving-wall"] {
        assert!(least(&rows(name), |row| row.f_env) >= 0.0, "{name}");
    }
}
