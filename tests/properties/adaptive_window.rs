//! Adaptive window against the longest one that a line fits, found by testing every line against every sample.

use approx::abs_diff_eq;
use proptest::array::uniform16;
use proptest::collection::vec;
use proptest::prelude::any;
use proptest::prop_assert;

use lyapunov::{HeldTick, OnePort, PortSample, Scalar, effects::OnePortExt, environments::Spring};

use crate::support::{
    Bits, CASES, Port, Real, Scripted, Spy, drive_of, hold, log_between, same_axes,
};

const ROOM: usize = 16;

/// The samples that a port inside a window of up to `ticks` receives.
fn told<V: Port>(ticks: u32, band: V::Scalar, drives: &[PortSample<V>]) -> Vec<PortSample<V>> {
    let mut spy = Spy::on(Scripted::of(Vec::new()));
    let mut port = (&mut spy).windowed::<ROOM>(ticks, band).expect("a window");
    for sample in drives {
        port.respond(sample);
    }
    spy.asked
}

/// The samples of a motion through these positions.
fn through<V: Port>(period: V::Scalar, positions: &[V]) -> Vec<PortSample<V>> {
    let before = |n: usize| positions[n.max(1) - 1];
    (0..positions.len())
        .map(|n| {
            HeldTick {
                period,
                position: positions[n],
                velocity: V::zero(),
                displacement: positions[n] - before(n),
                applied: V::zero(),
            }
            .sample()
        })
        .collect()
}

/// The window at the last of these counts, in whole numbers: every line against every count between.
fn window(counts: &[i64], ticks: u32, band: i64) -> usize {
    let now = counts.len() - 1;
    let fits = |i: usize| {
        (1..i).all(|j| {
            let along = j as i64 * (counts[now] - counts[now - i]);
            (i as i64 * (counts[now] - counts[now - j]) - along).abs() <= i as i64 * band
        })
    };
    (1..=now.min(ticks as usize)).take_while(|i| fits(*i)).last().unwrap_or(0)
}

/// A motion in counts: rests, steady motion, jerks and chatter.
fn walk(samples: &[[Bits; 16]], axis: usize) -> Vec<i64> {
    let (mut at, mut speed) = (0i64, 0i64);
    samples
        .iter()
        .map(|bits| {
            let bits = bits[axis];
            match bits % 16 {
                0 => speed = (bits >> 8) as i64 % 7 - 3,
                1 => speed = 0,
                2 => speed = (bits >> 8) as i64 % 60 - 30,
                _ => {}
            }
            at = (at + speed).clamp(-1000, 1000);
            at + (bits >> 32) as i64 % 2 * ((bits >> 40) as i64 % 3 - 1)
        })
        .collect()
}

mod check {
    use super::*;

    /// Counts of any resolution, with a band of some counts: lines just one band off are in, farther ones out.
    pub(super) fn windows_are_the_longest<V: Port>() {
        let samples = vec(uniform16(any::<Bits>()), 1..40);
        hold(CASES / 4, (1..=ROOM as u32, any::<Bits>(), samples), |(ticks, bits, samples)| {
            let period = V::Scalar::of(1e-3);
            let resolution = V::Scalar::of(log_between(bits, 1e-7, 1e-3));
            let band = (bits % 3) as i64;
            let walks: Vec<_> = (0..V::AXES).map(|axis| walk(&samples, axis)).collect();
            let positions: Vec<V> = (0..samples.len())
                .map(|n| V::from_axes(|axis| V::Scalar::of(walks[axis][n] as f64) * resolution))
                .collect();
            let drives = through(period, &positions);
            let told = told(ticks, V::Scalar::of(band as f64) * resolution, &drives);
            for (n, told) in told.iter().enumerate() {
                for (axis, walk) in walks.iter().enumerate() {
                    let i = window(&walk[..=n], ticks, band);
                    let counts = (walk[n] - walk[n - i]) as f64 / i.max(1) as f64;
                    let expected = counts * resolution.f64() / period.f64();
                    let found = told.velocity.axis(axis).f64();
                    // The rounding of two positions of up to 1001 counts.
                    let slack = 4.0 * 1001.0 * V::Scalar::unit() * resolution.f64() / period.f64();
                    prop_assert!(
                        abs_diff_eq!(found, expected, epsilon = slack),
                        "call {n}, axis {axis}: {found:e} for {expected:e}, a window of {i}"
                    );
                }
                prop_assert!(
                    *told == PortSample { velocity: told.velocity, ..drives[n] },
                    "{told:?}"
                );
            }
            Ok(())
        });
    }

    /// A window of one tick is the backward difference, to the bit.
    pub(super) fn one_tick_is_the_difference<V: Port>() {
        let samples = vec(uniform16(any::<Bits>()), 1..24);
        hold(CASES, (any::<Bits>(), samples), |(bits, samples)| {
            let tame = bits % 2 == 0;
            let mut drives: Vec<PortSample<V>> =
                samples.iter().map(|bits| drive_of(*bits, tame, V::Scalar::of(1e-3)).0).collect();
            drives[0].displacement = V::zero();
            let mut spy = Spy::on(Scripted::of(Vec::new()));
            for sample in &drives {
                (&mut spy).differenced().respond(sample);
            }
            let band = V::Scalar::of(log_between(bits, 1e-9, 1e9));
            for (told, expected) in told(1, band, &drives).iter().zip(&spy.asked) {
                prop_assert!(same_axes(told.velocity, expected.velocity), "{told:?}");
                prop_assert!(same_axes(told.work, expected.work));
            }
            Ok(())
        });
    }

    /// Straight motion in numbers without rounding uses the whole window without any band, and a kink in it cuts the
    /// window there.
    pub(super) fn straight_motion_needs_no_band<V: Port>() {
        let (period, zero) = (V::Scalar::of(0.25), V::Scalar::of(0.0));
        let kink = 30;
        let at = |n: usize, axis: usize| {
            let slope = [0.75, 0.0, -2.5][axis];
            let after = n.max(kink) - kink;
            V::Scalar::of(slope * (n - after) as f64 - 1.25 * after as f64 + 8.0)
        };
        let positions: Vec<V> = (0..60).map(|n| V::from_axes(|axis| at(n, axis))).collect();
        for (n, told) in told(ROOM as u32, zero, &through(period, &positions)).iter().enumerate() {
            for axis in 0..V::AXES {
                let i = if n > kink { ROOM.min(n - kink) } else { ROOM.min(n) };
                let before = at(n - i, axis).f64();
                let expected = (at(n, axis).f64() - before) / (i.max(1) as f64 * 0.25);
                assert_eq!(told.velocity.axis(axis).f64(), expected, "call {n}, axis {axis}");
            }
        }
    }
}

crate::support::every_port!(
    windows_are_the_longest,
    one_tick_is_the_difference,
    straight_motion_needs_no_band,
);

/// A turn within the band: the line from one end to the other leaves it, shorter ones do not.
#[test]
fn a_bend_is_cut_where_it_leaves_the_band() {
    // A parabola: sample j lies j (i − j) off the chord over i ticks.
    let positions: Vec<f64> = (0..40).map(|n| f64::from(n * n)).collect();
    for (band, i) in [(0.5, 1), (1.0, 2), (1.9, 2), (2.0, 3), (4.0, 4), (6.0, 5), (9.0, 6)] {
        let told = told(12, band, &through(1.0, &positions));
        for (n, told) in told.iter().enumerate().skip(13) {
            assert_eq!(told.velocity, (2 * n - i) as f64, "call {n} with a band of {band}");
        }
    }
}

/// A position that is not finite ends the windows that would reach it and has no other effect.
#[test]
fn bad_positions_end_windows() {
    for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut positions: Vec<f64> = (0..40).map(|n| f64::from(n) * 0.5).collect();
        positions[10] = wrong;
        for (n, told) in told(8, 0.25, &through(1.0, &positions)).iter().enumerate().skip(1) {
            match n {
                10 | 11 => assert!(!told.velocity.is_finite()),
                _ => assert_eq!(told.velocity, 0.5, "call {n}"),
            }
        }
    }
}

#[test]
fn wrong_windows_are_refused() {
    let spring = Spring::<f64>::new(1.0).expect("a spring");
    for ticks in [0, 5] {
        let error = spring.windowed::<4>(ticks, 0.0).expect_err("wrong ticks");
        assert_eq!((error.parameter, error.value), ("window ticks", f64::from(ticks)));
    }
    let least = "ticks is 0.0; it must be at least 1.0 and finite";
    let none = spring.windowed::<4>(0, 0.0).expect_err("no ticks").to_string();
    assert_eq!(none, format!("window {least}"));
    let none = OnePortExt::<f64>::held(spring, 0).expect_err("no ticks").to_string();
    assert_eq!(none, format!("hold {least}"));
    for band in [-1e-9, f64::NAN, f64::INFINITY] {
        let error = spring.windowed::<4>(4, band).expect_err("a wrong band");
        assert_eq!(error.parameter, "window band");
    }
    assert!(spring.windowed::<4>(4, 0.0).is_ok());
}
