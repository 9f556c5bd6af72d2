//! Tests of the measures on traces made up by hand, at 100 Hz from a start of 4 mm.

use std::f64::consts::TAU;

use approx::assert_abs_diff_eq;

use super::*;

const PERIOD: f64 = 0.01;
const START_OF_RUN: f64 = 0.004;

/// The trace of `seconds` s whose points are `at` each time.
fn trace(seconds: f64, at: impl Fn(f64) -> Point) -> Trace {
    let mut trace = Trace::new(PERIOD, START_OF_RUN);
    let ticks = (seconds / PERIOD).round() as u32;
    (0..=ticks).for_each(|tick| trace.push(at(f64::from(tick) * PERIOD)));
    trace
}

fn moving(seconds: f64, x: impl Fn(f64) -> f64) -> Trace {
    trace(seconds, |t| Point { x: x(t), ..Point::default() })
}

fn decaying(t: f64) -> f64 {
    START_OF_RUN * (-t).exp()
}

#[test]
fn a_decay_settles_where_it_enters_the_band_for_good() {
    // 5 % of the start at t = ln 20 = 2.996 s, so from tick 300 on.
    let settled = Measures::of(&moving(30.0, decaying));
    assert_eq!(settled.settled, Some(3.0));
    assert!(!settled.grows && settled.left.is_none());
    // A visit of less than 3 s is none.
    let visit = |t: f64| if (1.0..3.9).contains(&t) { 0.0 } else { decaying(t / 4.0) };
    assert_eq!(Measures::of(&moving(30.0, visit)).settled, Some(11.99));
    // Nor is one that begins too late.
    let late = |t: f64| if t < 27.5 { START_OF_RUN } else { 0.0 };
    assert_eq!(Measures::of(&moving(60.0, late)).settled, None);
}

#[test]
fn a_run_that_passes_ten_times_its_start_grows_unless_it_settles() {
    let growing = |t: f64| START_OF_RUN * t.exp();
    let grown = Measures::of(&moving(30.0, growing));
    // e^t = 10 at 2.303 s.
    assert_eq!((grown.settled, grown.left, grown.grows), (None, Some(2.31), true));
    let burst = |t: f64| if t < 1.0 { 20.0 * START_OF_RUN } else { 0.0 };
    let settled = Measures::of(&moving(30.0, burst));
    assert_eq!((settled.settled, settled.left, settled.grows), (Some(1.0), Some(0.0), false));
    let lost = Measures::of(&moving(30.0, |t| if t < 1.0 { START_OF_RUN } else { f64::NAN }));
    assert_eq!((lost.settled, lost.left, lost.grows), (None, Some(1.0), true));
}

#[test]
fn a_steady_swing_neither_settles_nor_grows_and_a_slow_growth_does() {
    let swing = |rate: f64| {
        let at = move |t: f64| START_OF_RUN * (rate * t).exp() * (TAU * 2.0 * t).cos();
        Measures::of(&moving(30.0, at))
    };
    let steady = swing(0.0);
    assert_eq!((steady.settled, steady.grows), (None, false));
    assert_abs_diff_eq!(steady.growth.unwrap(), 1.0, epsilon = 1e-12);
    assert!(swing(0.01).grows && !swing(-0.01).grows);
    // One swing of 0.5 s later.
    assert_abs_diff_eq!(swing(0.5).growth.unwrap(), 0.25_f64.exp(), epsilon = 1e-3);
}

/// A contact from 0.1 to 0.2 s whose force peaks at 3 N and whose energy peaks at 2 mJ; the controller answers with
/// 1.2 N the other way, 0.05 s later; the energy falls to -5 mJ.
fn contact(t: f64) -> Point {
    let tick = (t / PERIOD).round() as i32;
    let force = if (10..20).contains(&tick) { 3.0 * (TAU * (t - 0.095) * 5.0).sin() } else { 0.0 };
    let (alpha, v) = if tick == 25 { (12.0, -0.1) } else { (0.0, 0.05) };
    let booked = match tick {
        15 => 2e-3,
        22 => -7e-3,
        24 => 1e-3,
        _ => 0.0,
    };
    let observed_energy = match tick {
        ..15 => 0.0,
        15..22 => 2e-3,
        22..24 => -5e-3,
        _ => -4e-3,
    };
    let x = if tick < 26 { -START_OF_RUN } else { 0.0 };
    Point { x, v, force, alpha, observed_energy, booked }
}

#[test]
fn the_first_contact_and_the_reply_to_it_are_found() {
    let run = Measures::of(&trace(30.0, contact));
    assert_eq!(run.settled, Some(0.26));
    assert_abs_diff_eq!(run.force_peak, 3.0 * (TAU * 0.25).sin(), epsilon = 0.05);
    assert_abs_diff_eq!(run.reply, -1.2, epsilon = 1e-15);
    assert_eq!((run.energy_peak, run.energy_least), (2e-3, -5e-3));
    assert_eq!(run.energy_settled, Some(-4e-3));
    assert_abs_diff_eq!(run.largest_step, 7e-3, epsilon = 1e-15);
    assert_abs_diff_eq!(run.variation, 10e-3, epsilon = 1e-15);
    // 1.2 N against a way of 4 mm: the force is -1.2 N and the way is +4 mm.
    assert_abs_diff_eq!(run.taken, -1.2 * 0.004, epsilon = 1e-15);
    // A run that never touches has no contact.
    let free = Measures::of(&moving(30.0, decaying));
    assert_eq!((free.force_peak, free.reply, free.swing), (0.0, 0.0, 0.0));
}

#[test]
fn turns_are_counted_beyond_a_thousandth_of_the_start() {
    // 5 swings of 1 % in the second after settling turn ten times, less the one that is not over.
    let shaking = |share: f64| {
        let at = move |t: f64| {
            if t < 1.0 { START_OF_RUN } else { share * START_OF_RUN * (TAU * 5.0 * t).sin() }
        };
        Measures::of(&moving(30.0, at)).turns
    };
    assert_eq!(shaking(0.01), Some(10));
    assert_eq!(shaking(0.0004), Some(0));
    assert_eq!(Measures::of(&moving(30.0, decaying)).turns, Some(0));
    assert_eq!(Measures::of(&moving(30.0, |_| START_OF_RUN)).turns, None);
}

#[test]
fn what_follows_a_decision_changes_nothing() {
    // At rest the energy still moves, in steps below its last digit, for as long as anybody looks.
    let resting = |t: f64| Point { booked: 1e-48, alpha: 7.0, v: 1e-20, ..contact(t) };
    let at = |t: f64| if t < 0.3 { contact(t) } else { resting(t) };
    let (short, long) = (Measures::of(&trace(30.0, at)), Measures::of(&trace(60.0, at)));
    assert_eq!(short, long);
    let swinging = |t: f64| Point { booked: t, x: START_OF_RUN, ..contact(t) };
    assert_eq!(Measures::of(&trace(30.0, swinging)), Measures::of(&trace(60.0, swinging)));
    assert_eq!(Measures::of(&Trace::new(PERIOD, START_OF_RUN)).settled, None);
}
