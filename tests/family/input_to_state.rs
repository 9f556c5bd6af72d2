//! The input-to-state stable approach against its worked rows, its limits and its storage.

use lyapunov::{
    HeldTick, OnePort, PortSample, Scalar, Snapshot,
    bodies::Impedance,
    environments::{Spring, Wall},
    laws,
    stabilizers::InputToState,
};

use crate::support::{HELD, PERIOD, swing};
use crate::worked::{answers, near};

const STIFFNESS: f64 = 5000.0;

fn wall<T: Scalar>() -> Wall<T> {
    Wall::new(T::of(STIFFNESS), T::of(0.0)).expect("a wall")
}

fn rows<T: Scalar>() {
    let of = |slope: f64, feed: f64| {
        answers::<T>(InputToState::new(wall::<T>(), T::of(slope), T::of(feed)).expect("one"))
    };
    let row = [0.0, 0.5, 1.20588, 2.29066, 2.65255, 2.43967, 1.5649, 0.579472, 0.159134, 0.0];
    near(&of(8500.0, 0.0), &row);
    let row =
        [0.0, 3.0, 4.73529, 7.71453, 4.46204, 1.37527, -2.80898, -4.34766, -1.94255, -0.795671];
    near(&of(8500.0, 5e-3), &row);
    let adaptive = InputToState::adaptive(wall::<T>(), T::of(1.7), T::of(5e-3)).expect("one");
    near(&answers::<T>(adaptive), &row);
    let row = [0.0, 1.5, 2.75, 4.625, 3.6875, 2.15625, -0.078125, -1.46094, -0.769531, -0.351563];
    near(&of(10_000.0, 2e-3), &row);
}

crate::worked::each_scalar!(the_worked_rows, rows);

#[test]
fn an_infinite_slope_is_the_bare_environment() {
    let port = InputToState::new(wall::<f64>(), f64::INFINITY, 0.0).expect("one");
    assert_eq!(answers::<f64>(port), answers::<f64>(wall()));
}

/// `K' = K μ / (K + μ)`, whatever the rate's share.
#[test]
fn at_rest_it_is_the_series_of_both() {
    for (slope, feed) in [(8500.0, 0.0), (8500.0, 5e-3), (6000.0, 2e-3)] {
        let mut port = InputToState::new(wall::<f64>(), slope, feed).expect("one");
        let mut force = port.respond(
            &HeldTick {
                period: PERIOD,
                position: 1e-3,
                velocity: 1.0,
                displacement: 1e-3,
                applied: 0.0,
            }
            .sample(),
        );
        for _ in 0..500 {
            force = port.respond(
                &HeldTick {
                    period: PERIOD,
                    position: 1e-3,
                    velocity: 0.0,
                    displacement: 0.0,
                    applied: force,
                }
                .sample(),
            );
        }
        let series = STIFFNESS * slope / (STIFFNESS + slope);
        assert!((force - 1e-3 * series).abs() < 1e-9, "{force} N");
    }
    // Of the published share, 0.630 of the spring.
    let share = 1.7_f64;
    assert!((share / (1.0 + share) - 0.630).abs() < 1e-3);
}

/// A spring that writes down what it was asked and what it answered.
struct Recorder {
    asked: Vec<f64>,
    answered: Vec<f64>,
}

impl OnePort<f64> for Recorder {
    fn respond(&mut self, sample: &PortSample<f64>) -> f64 {
        let force = STIFFNESS * sample.position.max(0.0);
        self.asked.push(sample.position);
        self.answered.push(force);
        force
    }
}

/// `∫ F v = W(q) + f² / (2 μ) + τ ∫ ḟ q̇ + (τ / μ) ∫ ḟ²`, in the limit of a small period.
#[test]
fn the_work_is_what_is_stored_and_burnt() {
    let (period, slope, feed) = (1e-6, 8500.0, 5e-3);
    let mut recorder = Recorder { asked: vec![], answered: vec![] };
    let mut port = InputToState::new(&mut recorder, slope, feed).expect("one");
    let at = |time: f64| 1e-3 * (60.0 * time).sin();
    let (mut force, mut work, mut position) = (0.0, 0.0, 0.0);
    for tick in 0..100_000 {
        let next = at(f64::from(tick) * period);
        let moved = next - position;
        let last = force;
        force = port.respond(
            &HeldTick {
                period,
                position: next,
                velocity: moved / period,
                displacement: moved,
                applied: last,
            }
            .sample(),
        );
        work += 0.5 * (last + force) * moved;
        position = next;
    }
    let (q, f) = (recorder.asked, recorder.answered);
    let (mut shifted, mut rates) = (0.0, 0.0);
    for tick in 1..q.len() {
        let (step, change) = (q[tick] - q[tick - 1], f[tick] - f[tick - 1]);
        shifted += change / period * step;
        rates += change * change / period;
    }
    let (q, f) = (q[q.len() - 1].max(0.0), f[f.len() - 1]);
    let stored = 0.5 * STIFFNESS * q * q + f * f / (2.0 * slope);
    let burnt = feed * (shifted + rates / slope);
    assert!((work - stored - burnt).abs() < 1e-3 * work, "{work} for {stored} and {burnt}");
    assert!(burnt > stored);
}

/// It brakes: a wall that a hold makes active settles, which a bounding law only bounds.
#[test]
fn it_settles_a_spring_that_swings_up() {
    let spring = || Spring::new(STIFFNESS).expect("a spring");
    let (alone, _) = swing(HELD, spring(), 20_000);
    let port = InputToState::new(spring(), 1.7 * STIFFNESS, 5e-3).expect("one");
    let (most, late) = swing(HELD, port, 20_000);
    assert!(alone > 1.0 && most <= 1.1e-3 && late < 1e-9, "{alone} m; {most} m, then {late} m");
}

/// Of a free mass, asked at `x`, it is a sampled spring and damper: `K T² / m < 2 β (2 − β) / (2 + β)`, `β = τ K T / m`.
#[test]
fn a_hold_keeps_the_rule_of_the_sampled_spring() {
    let free = Impedance { damping: 0.0, stiffness: 0.0, ..HELD };
    for share in [0.2, 0.83, 1.5] {
        let most = 2.0 * share * (2.0 - share) / (2.0 + share);
        let late = |of_most: f64| {
            let stiffness = of_most * most * free.mass / (PERIOD * PERIOD);
            let feed = share * free.mass / (stiffness * PERIOD);
            let spring = Spring::new(stiffness).expect("a spring");
            let port = InputToState::new(spring, f64::INFINITY, feed).expect("one");
            swing(free, port, 20_000).1
        };
        let (below, above) = (late(0.97), late(1.03));
        assert!(below < 1e-9 && above > 1.0, "{below} m and {above} m at {share}");
    }
}

/// The least `μ` that is watched is the published share of the largest slope seen.
#[test]
fn what_is_watched_is_the_slope() {
    let mut port = InputToState::adaptive(wall::<f64>(), 2.0, 0.0).expect("one");
    assert_eq!(port.slope(), 0.0);
    for tick in 0..50 {
        let moved = 1e-4;
        port.respond(
            &HeldTick {
                period: PERIOD,
                position: moved * f64::from(tick),
                velocity: 0.1,
                displacement: moved,
                applied: 0.0,
            }
            .sample(),
        );
    }
    assert!((port.slope() - 2.0 * STIFFNESS).abs() < 1e-6, "{}", port.slope());
}

/// The first position that is known is no motion from 0, whatever came before it.
#[test]
fn a_lost_first_position_is_no_motion() {
    let spring = Spring::new(1000.0).expect("a spring").at(-5e-3);
    let fresh = InputToState::adaptive(spring, 1.7, 0.0).expect("one");
    let at = |position, displacement| {
        let (velocity, applied) = (displacement / PERIOD, 0.0);
        HeldTick { period: PERIOD, position, velocity, displacement, applied }.sample()
    };
    let mut port = fresh;
    for sample in [at(f64::NAN, 0.0), at(1e-6, 0.0), at(2e-6, 1e-6)] {
        port.respond(&sample);
    }
    assert!((port.slope() / 1700.0 - 1.0).abs() < 1e-6, "{}", port.slope());
    assert!(fresh.restored(fresh.state()).is_ok());
    let (inner, slope, answer, _, shift) = port.state();
    assert!(fresh.restored((inner, slope, answer, f64::INFINITY, shift)).is_err());
}

#[test]
fn laws_lanes_and_what_is_refused() {
    let port = InputToState::new(wall::<f64>(), 8500.0, 5e-3).expect("one");
    laws::one_port(&port, laws::Samples::<f64>::new(PERIOD)).expect("the laws");
    let mut spoilt = port;
    let sound = HeldTick {
        period: PERIOD,
        position: 1e-3,
        velocity: 0.1,
        displacement: 1e-4,
        applied: 0.0,
    }
    .sample();
    spoilt.respond(&sound);
    assert!(!spoilt.respond(&PortSample { position: f64::NAN, ..sound }).is_finite());
    assert!(spoilt.respond(&sound).is_finite());

    assert!(InputToState::<_, f64>::new(wall::<f64>(), 0.0, 0.0).is_err());
    assert!(InputToState::<_, f64>::new(wall::<f64>(), f64::NAN, 0.0).is_err());
    assert!(InputToState::<_, f64>::new(wall::<f64>(), 1.0, -1.0).is_err());
    assert!(InputToState::<_, f64>::adaptive(wall::<f64>(), 1.0, 0.0).is_err());
}
