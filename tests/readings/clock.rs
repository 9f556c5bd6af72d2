//! The contract of time.

use proptest::collection::vec;
use proptest::prelude::any;
use proptest::{prop_assert, prop_assert_eq, proptest};

use lyapunov::readings::CheckedSample;
use lyapunov::{MovingReading, Scalar};

use crate::support::{PERIOD, reading, readings};

/// What it shows, times, and what is told of each.
type Case = (&'static str, &'static [f64], &'static [(f64, bool)]);

/// The period told for each of these times, in periods, and whether the time was used.
fn told(times: &[f64]) -> Vec<(f64, bool)> {
    let mut readings = readings::<f64>().clocked();
    let told = |checked: CheckedSample<f64>| (checked.sample.period / PERIOD, checked.timed);
    let times = times.iter().map(|time| time * PERIOD);
    times.map(|time| told(readings.read_at(time, reading(0.0, 0.0)))).collect()
}

#[test]
fn times_count_as_they_are_defined_to() {
    let table: [Case; 12] = [
        ("in time", &[70.0, 71.0, 72.0], &[(1.0, true), (1.0, true), (1.0, true)]),
        ("late, then early", &[0.0, 3.0, 3.5], &[(1.0, true), (3.0, true), (0.5, true)]),
        ("NaN", &[5.0, f64::NAN, 7.0], &[(1.0, true), (1.0, false), (1.0, true)]),
        ("infinite", &[5.0, f64::INFINITY, 7.0], &[(1.0, true), (1.0, false), (1.0, true)]),
        (
            "too coarse",
            &[4.0, 4.0, 6.0, 6.0],
            &[(1.0, true), (1.0, false), (1.0, true), (1.0, false)],
        ),
        (
            "standing",
            &[4.0, 4.0, 4.0, 8.0],
            &[(1.0, true), (1.0, false), (1.0, false), (2.0, true)],
        ),
        (
            "standing longer than it goes on",
            &[4.0, 4.0, 4.0, 5.0, 6.0],
            &[(1.0, true), (1.0, false), (1.0, false), (1.0, false), (1.0, true)],
        ),
        (
            "hardly farther than was counted",
            &[4.0, 4.0, 5.001, 6.001],
            &[(1.0, true), (1.0, false), (1.0, false), (1.0, true)],
        ),
        (
            "a little farther than was counted",
            &[4.0, 4.0, 5.75, 6.0],
            &[(1.0, true), (1.0, false), (0.75, true), (0.25, true)],
        ),
        ("set back", &[900.0, 2.0, 3.0], &[(1.0, true), (1.0, false), (1.0, true)]),
        ("NaN at first", &[f64::NAN, 8.0, 9.0], &[(1.0, false), (1.0, true), (1.0, true)]),
        ("below 0", &[-9.0, -8.0, -7.0], &[(1.0, true), (1.0, true), (1.0, true)]),
    ];
    for (name, times, expected) in table {
        assert_eq!(told(times), expected, "{name}");
    }
}

/// A clock that stands still counts one period a tick for as long as it does.
#[test]
fn a_clock_that_stands_counts_periods() {
    let (first, rest) = (told(&[3.0; 50])[0], told(&[3.0; 50])[1..].to_vec());
    assert_eq!(first, (1.0, true));
    assert!(rest.iter().all(|&tick| tick == (1.0, false)));
}

/// A clock that goes on once in ten ticks counts as many periods as there were.
#[test]
fn a_coarse_clock_keeps_time() {
    let times: Vec<f64> = (0..300).map(|tick| f64::from(tick / 10 * 10)).collect();
    let told = told(&times);
    assert_eq!(told.iter().map(|(period, _)| period).sum::<f64>(), 300.0);
    assert!(told.iter().enumerate().all(|(tick, (_, timed))| *timed == (tick % 10 == 0)));
}

/// A motion of 0.1 mm a tick is 0.1 m/s, also where the clock goes on a microsecond after what was counted while it stood.
#[test]
fn a_clock_that_stood_makes_no_speed() {
    let mut readings = lyapunov::Readings::<f64>::every(1e-3).expect("a period").clocked();
    readings.read_at(0.004, reading(0.0, 0.0));
    for (now, position) in [(0.004, 1e-4), (0.005_001, 2e-4), (0.006_001, 3e-4)] {
        let velocity = readings.read_at(now, reading(position, 0.0)).sample.velocity;
        assert!((velocity - 0.1).abs() < 1e-9, "{velocity} m/s at {now} s");
    }
}

/// A clock of 0.7 periods and one of 1.4, both too coarse for good, are heard again and again, and no time is lost.
#[test]
fn a_coarse_clock_is_heard_for_good() {
    for grain in [0.7, 1.4] {
        let times: Vec<f64> =
            (0..300).map(|tick| (f64::from(tick) / grain).floor() * grain).collect();
        let told = told(&times);
        let sum: f64 = told[1..].iter().map(|(period, _)| period).sum();
        assert!(sum >= times[299] - times[0], "{sum} periods");
        assert!(told.windows(8).all(|eight| eight.iter().any(|(_, timed)| *timed)), "{grain}");
    }
}

/// A tick is late from one and a half periods on.
#[test]
fn a_late_tick_is_noticed() {
    for (after, late) in [(1.0, false), (1.5, false), (1.5625, true), (40.0, true)] {
        let mut readings = readings::<f64>().clocked();
        readings.read_at(0.0, reading(0.0, 0.0));
        let checked = readings.read_at(after * PERIOD, reading(0.5, 2.0));
        assert_eq!((checked.late, checked.sample.work), (late, 1.0), "{after}");
        assert_eq!(checked.sample.velocity, 0.5 / (after * PERIOD));
    }
}

proptest! {
    /// While the clock is sound the periods add up to the time that went by, gaps of readings or not.
    #[test]
    fn periods_add_up(steps in vec((1u32..5000, any::<bool>()), 1..60), start in -1e6..1e6f64) {
        let start = start.trunc();
        let mut readings = readings::<f64>().clocked();
        readings.read_at(start, reading(0.0, 0.0));
        let (mut now, mut sum) = (start, 0.0);
        for (step, lost) in steps {
            now += f64::from(step) / 65536.0;
            if lost {
                readings.missed_at(now, 0.0);
            } else {
                sum += readings.read_at(now, reading(0.0, 0.0)).sample.period;
                prop_assert_eq!(sum, now - start);
            }
        }
    }

    /// Whatever the times, positions and efforts: an accepted sample is finite, its period above 0, and a time that can
    /// be used is used after any that could not.
    #[test]
    fn any_time_gives_a_sound_sample(
        ticks in vec((any::<f64>(), any::<f64>(), any::<f64>(), any::<f64>()), 1..40)
    ) {
        let mut readings = readings::<f64>().clocked();
        let mut moving = readings.measured();
        for (now, position, velocity, applied) in ticks {
            let by_difference = readings.read_at(now, reading(position, applied));
            let by_device =
                moving.read_moving_at(now, MovingReading { position, velocity, applied });
            for checked in [by_difference, by_device] {
                prop_assert_eq!(checked.accepted, checked.sample.finite(), "{:?}", checked);
                prop_assert!(checked.sample.period > 0.0, "{:?}", checked);
            }
        }
        readings.read_at(0.0, reading(0.0, 0.0));
        readings.read_at(1.0, reading(0.0, 0.0));
        let checked = readings.read_at(1.25, reading(0.0, 0.0));
        prop_assert!(checked.timed && checked.sample.period == 0.25);
    }
}

/// In `f32` a year on the clock still has its periods.
#[test]
fn a_year_has_its_periods() {
    let period = f32::of(1e-3);
    let mut readings = lyapunov::Readings::<f32>::every(period).expect("a period").clocked();
    let year = 3.2e7;
    readings.read_at(year, reading(0.0, 0.0));
    let checked = readings.read_at(year + 1e-3, reading(1e-3, 0.0));
    assert!((checked.sample.period - period).abs() < 1e-5 * period, "{checked:?}");
}
