//! Tests of the study against known figures.

use std::ops::ControlFlow;
use std::sync::Mutex;
use std::time::{Duration, Instant};

use super::*;
use crate::files::Scene;
use crate::simulate::Rollout;

fn study(text: &str) -> Study {
    let scene = Scene::parse(text, "scene.toml").unwrap();
    Study::watched("scene.toml", &scene, &|_| ControlFlow::Continue(())).unwrap()
}

/// The paper's wall of 8 kN/m without a stabilizer, with the plant's own velocity.
const WALL: &str = "
duration = 2.0
servo_rate = 100.0
velocity = \"exact\"
operator = { mass = 0.1, damping = 0.2, stiffness = 50.0 }
device = { mass = 0.2, damping = 0.001 }
initial.position = -0.004
environment.wall = { stiffness = 8000.0, damping = 2.0 }
";

fn error(study: &Study, propagator: &str, steps: Option<u32>, number: Number) -> f64 {
    let row = study.rows.iter().find(|row| {
        let Setting { integrator, number: of } = row.setting;
        of == number && integrator.name() == propagator && integrator.steps_per_tick() == steps
    });
    row.unwrap().max_error.unwrap()
}

/// Errors that an independent computation in sixty digits gives for the textbook methods on this scene, to two digits.
#[test]
fn errors_are_those_of_sixty_digits() {
    let study = study(WALL);
    let double = |propagator, steps| error(&study, propagator, steps, Number::F64);
    for (propagator, steps, want, digit) in [
        ("rk4", 1, 4.9e-4, 1e-5),
        ("rk4", 10, 4.5e-8, 1e-9),
        ("rk4", 20, 2.8e-9, 1e-10),
        ("rk4", 50, 7.1e-11, 1e-12),
        ("rk4", 100, 4.4e-12, 2e-13),
        ("semi-implicit-euler", 1, 2.0, 0.1),
        ("semi-implicit-euler", 10, 1.1, 0.1),
        ("semi-implicit-euler", 100, 7.5e-2, 1e-3),
    ] {
        let got = double(propagator, Some(steps));
        assert!((got - want).abs() <= digit, "{propagator} {steps}: {got:e} is not {want:e}");
    }
    assert!(double("exact", None) < 1e-13);
    assert!(error(&study, "exact", None, Number::F32) > 1e-9);
    assert!(study.rows.iter().all(|row| row.is_known && row.time.median > 0.0));
    assert!(!study.basis.growth.chaotic && study.basis.distance < 1e-26);
    assert!(study.rows.windows(2).all(|pair| pair[0].time.median <= pair[1].time.median));

    // Per simulated second, as a clock about the same loop tells, here with more about it.
    let exact = study.rows.iter().find(|row| row.setting.integrator.name() == "exact").unwrap();
    let (begun, mut seconds) = (Instant::now(), 0.0);
    while begun.elapsed() < Duration::from_millis(20) {
        let ticks = Rollout::<f64>::of(&study.scene).unwrap().count();
        seconds += ticks as f64 * study.scene.period();
    }
    let told = exact.time.median / (1e9 * begun.elapsed().as_secs_f64() / seconds);
    assert!((0.02..20.0).contains(&told), "{told}");
    // The figure has a point for each step of a method, from the coarsest to the finest.
    let curve = study.curve(Number::F64, "rk4");
    assert_eq!(curve.len(), 7);
    for (point, steps) in curve.iter().zip([1, 2, 5, 10, 20, 50, 100]) {
        assert!((point.1 - double("rk4", Some(steps)).log10()).abs() < 1e-12, "{steps}: {point:?}");
    }
}

/// Shares that are told on the way have no gap of more than a fifth.
#[test]
fn progress_is_told_evenly() {
    let told = Mutex::new(Vec::new());
    let scene = Scene::parse(WALL, "scene.toml").unwrap();
    let watch = |share| {
        told.lock().unwrap().push(share);
        ControlFlow::Continue(())
    };
    Study::watched("scene.toml", &scene, &watch).unwrap();
    let mut told = told.into_inner().unwrap();
    told.sort_by(f64::total_cmp);
    let gap = told.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
    let (first, last) = (told[0], told[told.len() - 1]);
    assert!((0.0..0.2).contains(&first) && last > 0.99 && gap < 0.2, "{first} {gap} {last}");
}

#[test]
fn a_duration_has_the_unit_that_suits_it() {
    for (nanoseconds, shown) in [
        (0.5, "0.50 ns"),
        (12.34, "12.3 ns"),
        (999.4, "999 ns"),
        (999.6, "1.00 µs"),
        (26_700.0, "26.7 µs"),
        (1.5e6, "1.50 ms"),
        (2e9, "2000 ms"),
    ] {
        assert_eq!(table::duration(nanoseconds), shown);
    }
}

/// The controlled loop: moving the start by 1e-13 m moves the trace by 1e-8 m after 2 s and by 1e-5 m after 3 s, so
/// deviations grow by some 5.8 to 6.9 /s, and traces of sixteen digits part after about 4 s.
#[test]
fn the_controlled_wall_is_chaotic() {
    let lolc = crate::studies::paper::Case::ALL.iter().find(|case| case.name() == "paper-8k-lolc");
    let study = study(lolc.unwrap().text());
    let growth = study.basis.growth;
    assert!(growth.chaotic);
    let exponent = growth.exponent.unwrap();
    assert!((5.0..9.0).contains(&exponent), "{exponent}");
    let exact = |number| {
        let mut rows = study.rows.iter().filter(|row| row.setting.number == number);
        rows.find(|row| row.setting.integrator.name() == "exact").unwrap().horizon.unwrap()
    };
    assert!((3.0..5.0).contains(&exact(Number::F64)), "{}", exact(Number::F64));
    assert!(exact(Number::F32) < exact(Number::F64));
    // The references tell for as long as their distance is a hundredth of what is believed, or less.
    let basis = &study.basis;
    let watch = |_| ControlFlow::Continue(());
    let ticks = trace::Progress::new(&watch);
    let references = reference::References::of(&study.scene, basis.all_ticks, ticks).unwrap();
    let within = |ticks| 100.0 * references.distance(ticks) <= basis.believed;
    assert!(within(basis.agreeing) && !within(basis.agreeing + 1), "{}", basis.agreeing);
    assert!(basis.agreeing as f64 * study.scene.period() > exact(Number::F64));
    assert!(study.rows.iter().any(|row| row.setting.number == Number::F32WithWideLedger));
    let shown = study.to_string();
    assert!(shown.lines().all(|line| line.chars().count() <= 100), "{shown}");
}

/// A held spring of 500 N/m at 100 Hz drives its mass apart by `K T / (4 m) = 6.25` a second, and deviations with it: as large, to
/// the share, at the end as at the start.
#[test]
fn a_loop_that_only_grows_is_not_chaotic() {
    let growing = "
        duration = 4.0
        servo_rate = 100.0
        device = { mass = 0.2, damping = 0.0 }
        initial.position = 0.01
        environment.spring.stiffness = 500.0
    ";
    let growth = study(growing).basis.growth;
    let exponent = growth.exponent.unwrap();
    assert!((5.5..6.5).contains(&exponent) && !growth.chaotic, "{exponent}");
}

/// The wall of 50 kN/m without a controller, from 4 mm to 2e25 m. Its tangent map gives 6.85 /s over the 10 s, and a growth of 1e5
/// in 0.99 s.
#[test]
fn a_deviation_is_small_beside_the_motion_of_its_time() {
    let none = crate::studies::paper::Case::ALL.iter().find(|case| case.name() == "paper-50k-none");
    let study = study(none.unwrap().text());
    let growth = study.basis.growth;
    let exponent = growth.exponent.unwrap();
    assert!((6.7..7.0).contains(&exponent) && !growth.chaotic, "{exponent}");
    let grown_at = growth.grown_at as f64 * study.scene.period();
    assert!((0.96..1.02).contains(&grown_at), "{grown_at}");
}

/// Ten million terms of about 2.7 µJ: a plain sum in `f32` loses hundredths, the others keep the digits of their port.
#[test]
fn ledgers_are_as_good_as_their_sums() {
    let watch = |_| ControlFlow::Continue(());
    let rows = ledger::rows(trace::Progress::new(&watch)).unwrap();
    let error = |scalar, ledger| {
        rows.iter().find(|row| (row.scalar, row.ledger) == (scalar, ledger)).unwrap().error
    };
    assert!(error("f32", "plain") > 1e-3);
    // Half a unit in the last place of 26.7 J, and the rounding of the terms.
    assert!(error("f32", "compensated") < 2e-6 && error("f32", "wide") < 2e-6);
    assert!(error("f64", "plain") < 1e-8);
    assert!(error("f64", "compensated") < 5e-15 && error("f64", "wide") < 5e-15);
}

#[test]
fn a_space_is_rejected_and_a_watch_may_end_the_study() {
    let plane = crate::files::shipped::SCENES.iter().find(|scene| scene.name == "plane").unwrap();
    let scene = Scene::parse(plane.text, "plane.toml").unwrap();
    let refused = Study::watched("plane.toml", &scene, &|_| ControlFlow::Continue(()));
    assert!(refused.unwrap_err().to_string().contains("[space]"));
    let scene = Scene::parse(WALL, "scene.toml").unwrap();
    let stopped = Study::watched("scene.toml", &scene, &|_| ControlFlow::Break(()));
    assert_eq!(stopped.unwrap_err(), AccuracyError::Stopped);
}
