//! Trajectories against the formulas of their definitions.

use std::f64::consts::PI;

use approx::{abs_diff_eq, assert_abs_diff_eq};
use nalgebra::Vector3;
use proptest::array::uniform8;
use proptest::prelude::any;
use proptest::{prop_assert, prop_assert_eq};

use lyapunov::{
    Requirement,
    trajectories::{
        Constant, FirstAxis, Pulse, Ramp, RampParts, Samples, Sine, Step, Trajectory, tick_of,
    },
};

use crate::support::{Bits, CASES, hold, log_between, ordinary, unit};

fn at(trajectory: &impl Trajectory<f64>, tick: u64) -> f64 {
    trajectory.at(tick)
}

/// A servo rate as in scenes, and an instant that is sometimes on a tick except for its rounding.
fn instant(bits: [Bits; 3]) -> (f64, f64) {
    let rate = [10.0, 100.0, 1000.0, 4000.0, 3.0, 7.3, log_between(bits[0], 0.1, 1e5)]
        [(bits[0] % 7) as usize];
    let ticks = match bits[1] % 3 {
        0 => 1000.0 * unit(bits[2]),
        _ => (bits[2] % 1000) as f64,
    };
    (rate, ticks / rate)
}

#[test]
fn an_instant_counts_from_its_tick() {
    for (instant, rate, tick) in [
        (0.0, 1000.0, 0),
        (0.3, 10.0, 3),
        (0.1 + 0.2, 10.0, 3),
        (0.7, 10.0, 7),
        (0.25, 10.0, 3),
        (0.3 + 5e-11, 10.0, 3),
        (0.3 + 2e-10, 10.0, 4),
        (0.3 - 2e-10, 10.0, 3),
        (1e-12, 10.0, 0),
        (0.201, 1000.0, 201),
        (4.35, 100.0, 435),
        (-3.0, 10.0, 0),
        (f64::NAN, 10.0, 0),
        (f64::NEG_INFINITY, 10.0, 0),
        (f64::INFINITY, 10.0, u64::MAX),
        (1e300, 1e300, u64::MAX),
        (1e17, 1e3, u64::MAX),
    ] {
        assert_eq!(tick_of(instant, rate), tick, "{instant} s at {rate} Hz");
    }
    for rate in [3.0, 10.0, 100.0, 1000.0, 4000.0, 44100.0] {
        for tick in 0..100_000u64 {
            assert_eq!(tick_of(tick as f64 / rate, rate), tick, "{tick} at {rate}");
            let late = (1 << 31) + tick;
            assert_eq!(tick_of(late as f64 / rate, rate), late, "{late} at {rate}");
        }
    }
}

#[test]
fn steps_and_pulses_begin_with_their_tick() {
    hold(CASES, uniform8(any::<Bits>()), |bits| {
        let (rate, start) = instant([bits[0], bits[1], bits[2]]);
        let (_, duration) = instant([bits[0], bits[3], bits[4]]);
        let (from, to) = (ordinary::<f64>(bits[5], 1.0), ordinary::<f64>(bits[6], 1.0));
        let step = Step::new(from, to, start, rate).expect("a step");
        let pulse = Pulse::new(to, start, duration, rate).expect("a pulse");
        let begin = (start * rate - 1e-9).ceil();
        let end = ((start + duration) * rate - 1e-9).ceil();
        for tick in (0..2100).chain([u64::MAX]) {
            let n = tick as f64;
            prop_assert_eq!(at(&step, tick), if n < begin { from } else { to });
            prop_assert_eq!(at(&pulse, tick), if begin <= n && n < end { to } else { 0.0 });
        }
        Ok(())
    });
    let thirds = Pulse::new(1.0, 0.3, 0.3, 10.0).expect("a pulse");
    let forces: Vec<f64> = (0..8).map(|tick| at(&thirds, tick)).collect();
    assert_eq!(forces, [0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0]);
}

#[test]
fn a_ramp_reaches_its_end_and_stops() {
    hold(CASES, uniform8(any::<Bits>()), |bits| {
        let (rate, start) = instant([bits[0], bits[1], bits[2]]);
        let (from, to) = (ordinary::<f64>(bits[3], 1.0), ordinary::<f64>(bits[4], 1.0));
        let speed = if bits[5] % 8 == 0 { 0.0 } else { log_between(bits[5], 1e-4, 100.0) };
        let parts = RampParts { from, to, rate: speed, at: start };
        let ramp = Ramp::new(parts, rate).expect("a ramp");
        let begin = (start * rate - 1e-9).ceil();
        for tick in 0..2100 {
            let n = tick as f64;
            let way = speed * (n / rate - start).max(0.0);
            let naive = match n < begin {
                true => from,
                false if way >= (to - from).abs() => to,
                false => from + (to - from).signum() * way,
            };
            let found = at(&ramp, tick);
            prop_assert!(
                abs_diff_eq!(found, naive, epsilon = 4.0 * f64::EPSILON),
                "{found} is not {naive}"
            );
            prop_assert!(from.min(to) <= found && found <= from.max(to), "{found}");
        }
        prop_assert!(speed == 0.0 || at(&ramp, u64::MAX) == to);
        Ok(())
    });
}

/// Whole turns in whole numbers: at `f / 4` Hz the tick `n` is `f n mod 4 R` parts of `4 R` into its turn.
#[test]
fn a_sine_is_as_good_late_as_early() {
    hold(CASES, uniform8(any::<Bits>()), |bits| {
        let (quarters, rate) = (bits[0] % 4000, 1 + bits[1] % 10_000);
        let (about, amplitude) = (ordinary::<f64>(bits[2], 0.1), ordinary::<f64>(bits[3], 1.0));
        let sine = Sine::new(about, amplitude, quarters as f64 / 4.0, rate as f64).expect("a sine");
        for tick in [bits[4] % 1000, bits[5] % 1_000_000, bits[6] % 1_000_000_000] {
            let part = (quarters * tick % (4 * rate)) as f64 / (4 * rate) as f64;
            let angle = 2.0 * PI * if part > 0.5 { part - 1.0 } else { part };
            let exact = about + amplitude * angle.sin();
            let found = at(&sine, tick);
            // Both angles are at most π, each with two or three roundings.
            let bound = 2e-15 * amplitude.abs() + 2e-17;
            prop_assert!(
                abs_diff_eq!(found, exact, epsilon = bound),
                "{found} is not {exact} at {tick}"
            );
        }
        Ok(())
    });
    hold(CASES, uniform8(any::<Bits>()), |bits| {
        let (frequency, rate) = (log_between(bits[0], 0.1, 50.0), log_between(bits[1], 10.0, 1e4));
        let sine = Sine::new(0.0, 1.0, frequency, rate).expect("a sine");
        let tick = bits[2] % 100;
        let angle = 2.0 * PI * frequency * (tick as f64 / rate);
        let bound = 1e-15 + 4.0 * f64::EPSILON * angle;
        prop_assert!(abs_diff_eq!(at(&sine, tick), angle.sin(), epsilon = bound));
        Ok(())
    });
}

#[test]
fn samples_are_joined_by_lines() {
    hold(CASES, uniform8(any::<Bits>()), |bits| {
        let rate = log_between(bits[0], 10.0, 1e4);
        let mut time = ordinary::<f64>(bits[1], 0.1);
        let rows: Vec<(f64, f64)> = (0..1 + bits[2] % 7)
            .map(|row| {
                time += (bits[3] >> (8 * row) & 0xff) as f64 / 16.0 / rate;
                (time, f64::from((bits[4] >> (8 * row)) as u8) / 32.0 - 4.0)
            })
            .collect();
        let samples = Samples::new(&rows[..], rate).expect("samples");
        for tick in 0..130 {
            let t = tick as f64 / rate;
            let last = rows.iter().rposition(|row| row.0 <= t);
            let naive = match last.map(|row| (rows[row], rows.get(row + 1))) {
                None => rows[0].1,
                Some(((_, value), None)) => value,
                Some(((t0, a), Some(&(t1, b)))) => (a * (t1 - t) + b * (t - t0)) / (t1 - t0),
            };
            let found = at(&samples, tick);
            prop_assert!(
                abs_diff_eq!(found, naive, epsilon = 1e-14 * 8.0),
                "{found} is not {naive}"
            );
        }
        Ok(())
    });
    let jump = Samples::new([(0.1, 1.0), (0.3, 3.0), (0.3, -1.0), (0.5, -1.0)], 10.0).expect("one");
    let values: Vec<f64> = (0..7).map(|tick| at(&jump, tick)).collect();
    assert_eq!(values[..2], [1.0, 1.0]);
    assert_abs_diff_eq!(values[2], 2.0, epsilon = 1e-15);
    assert_eq!(values[3..], [-1.0; 4]);
    assert_eq!(at(&Samples::new(vec![(5.0, 7.0)], 10.0).expect("one row"), 3), 7.0);
}

#[test]
fn trajectories_are_rounded_once() {
    let sine = Sine::new(0.1, 0.7, 3.0, 1000.0).expect("a sine");
    for tick in 0..1000 {
        let narrow: f32 = sine.at(tick);
        assert_eq!(narrow, at(&sine, tick) as f32);
    }
    let along = FirstAxis::of(sine, Vector3::new(9.0, 2.0, -3.0));
    assert_eq!(along.at(77), Vector3::new(at(&sine, 77), 2.0, -3.0));
    assert_eq!(at(&FirstAxis::of(sine, 5.0), 77), at(&sine, 77));
    assert_eq!(at(&|tick: u64| tick as f64, 3), 3.0);
}

/// Trajectories made of numbers at the ends of the range give numbers.
#[test]
fn hostile_trajectories_stay_finite() {
    let (huge, small) = (f64::MAX, f64::from_bits(1));
    for rate in [small, f64::MIN_POSITIVE, 1e-3, 1e3, huge] {
        for (big, speed) in [(huge, huge), (huge, small), (-huge, 0.0), (small, huge), (0.0, 0.0)] {
            let ramp = RampParts { from: big, to: -big, rate: speed, at: big };
            let courses: [Box<dyn Fn(u64) -> f64>; 4] = [
                Box::new(move |n| at(&Ramp::new(ramp, rate).expect("one"), n)),
                Box::new(move |n| at(&Sine::new(0.0, big, speed, rate).expect("one"), n)),
                Box::new(move |n| at(&Pulse::new(big, big, speed, rate).expect("one"), n)),
                Box::new(move |n| {
                    let rows = [(-1.0, big), (0.0, 0.0), (speed, big)];
                    at(&Samples::new(rows, rate).expect("samples"), n)
                }),
            ];
            for (kind, trajectory) in courses.iter().enumerate() {
                for tick in [0, 1, 1000, 1 << 53, u64::MAX] {
                    let value = trajectory(tick);
                    assert!(value.is_finite(), "{kind}: {value} at {tick} {rate} {big} {speed}");
                }
            }
        }
    }
}

#[test]
fn invalid_trajectories_are_refused() {
    use Requirement::{AtLeast, Finite, InRange, NonNegative, Positive};
    let of = |refused: Result<f64, lyapunov::ParameterError>| {
        let error = refused.expect_err("no trajectory");
        (error.parameter, error.requirement)
    };
    let trajectory = |made: Result<f64, _>| of(made);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let cases = [
            (trajectory(Constant::new(bad).map(|c| at(&c, 0))), ("value", Finite)),
            (trajectory(Step::new(bad, 1.0, 1.0, 1.0).map(|c| at(&c, 0))), ("from", Finite)),
            (trajectory(Step::new(1.0, bad, 1.0, 1.0).map(|c| at(&c, 0))), ("to", Finite)),
            (trajectory(Step::new(1.0, 1.0, bad, 1.0).map(|c| at(&c, 0))), ("at", Finite)),
            (
                trajectory(
                    Ramp::new(RampParts { from: 1.0, to: 1.0, rate: bad, at: 1.0 }, 1.0)
                        .map(|c| at(&c, 0)),
                ),
                ("rate", NonNegative),
            ),
            (trajectory(Sine::new(bad, 1.0, 1.0, 1.0).map(|c| at(&c, 0))), ("about", Finite)),
            (trajectory(Sine::new(1.0, bad, 1.0, 1.0).map(|c| at(&c, 0))), ("amplitude", Finite)),
            (
                trajectory(Sine::new(1.0, 1.0, bad, 1.0).map(|c| at(&c, 0))),
                ("frequency", NonNegative),
            ),
            (trajectory(Pulse::new(bad, 1.0, 1.0, 1.0).map(|c| at(&c, 0))), ("value", Finite)),
            (trajectory(Pulse::new(1.0, bad, 1.0, 1.0).map(|c| at(&c, 0))), ("start", Finite)),
            (
                trajectory(Pulse::new(1.0, 1.0, bad, 1.0).map(|c| at(&c, 0))),
                ("duration", NonNegative),
            ),
            (trajectory(Samples::new([(bad, 1.0)], 1.0).map(|c| at(&c, 0))), ("t", Finite)),
            (trajectory(Samples::new([(1.0, bad)], 1.0).map(|c| at(&c, 0))), ("value", Finite)),
            (
                trajectory(Samples::new([(1.0, 1.0)], bad).map(|c| at(&c, 0))),
                ("servo rate", Positive),
            ),
        ];
        for (found, expected) in cases {
            assert_eq!(found, expected);
        }
    }
    let refused = |made: Result<f64, _>, expected| assert_eq!(of(made), expected);
    refused(Sine::new(1e308, 1e308, 1.0, 1.0).map(|c| at(&c, 0)), ("amplitude", InRange));
    refused(Step::new(0.0, 1.0, 1.0, 0.0).map(|c| at(&c, 0)), ("servo rate", Positive));
    refused(Samples::new([], 1.0).map(|c| at(&c, 0)), ("rows", AtLeast(1.0)));
    let falling = Samples::new([(1.0, 0.0), (0.5, 0.0)], 1.0);
    refused(falling.map(|c| at(&c, 0)), ("t", AtLeast(1.0)));
    let apart = Samples::new([(0.0, 1e308), (0.5, -1e308)], 1.0);
    refused(apart.map(|c| at(&c, 0)), ("value", InRange));
}
