//! Low pass: its equation for the velocity, and no other change.

use std::f64::consts::TAU;

use approx::abs_diff_eq;
use proptest::array::uniform16;
use proptest::collection::vec;
use proptest::prelude::any;
use proptest::prop_assert;

use lyapunov::{HeldTick, OnePort, PortSample, Scalar, effects::OnePortExt, environments::Spring};

use crate::support::{Bits, CASES, Port, Real, Scripted, Spy, bad, drive_of, hold, log_between};

/// The samples that a port behind a low pass receives.
fn told<V: Port>(cutoff: V::Scalar, drives: &[PortSample<V>]) -> Vec<PortSample<V>> {
    let mut spy = Spy::on(Scripted::of(Vec::new()));
    let mut port = (&mut spy).low_passed(cutoff).expect("a low pass");
    for sample in drives {
        port.respond(sample);
    }
    spy.asked
}

mod check {
    use super::*;

    /// Against the sum that the recursion represents, `v(n) = Σ a (1−a)^k u(n−k)` over the calls after the first.
    pub(super) fn velocity_is_the_weighted_sum<V: Port>() {
        hold(CASES, (any::<Bits>(), vec(uniform16(any::<Bits>()), 1..24)), |(bits, samples)| {
            let period = V::Scalar::of(1e-3);
            let cutoff = V::Scalar::of(log_between(bits, 0.1, 1e5));
            let drives: Vec<PortSample<V>> =
                samples.iter().map(|bits| drive_of(*bits, true, period).0).collect();
            let turn = TAU * cutoff.f64() * period.f64();
            let share = turn / (1.0 + turn);
            for (n, told) in told(cutoff, &drives).iter().enumerate() {
                for axis in 0..V::AXES {
                    let rates: Vec<f64> = drives[..=n]
                        .iter()
                        .map(|sample| sample.displacement.axis(axis).f64() / period.f64())
                        .collect();
                    let terms =
                        (1..=n).map(|k| share * (1.0 - share).powi((n - k) as i32) * rates[k]);
                    let size = rates.iter().fold(0.0, |size: f64, rate| size.max(rate.abs()));
                    let off = told.velocity.axis(axis).f64() - terms.sum::<f64>();
                    let bound = 8.0 * (n + 1) as f64 * V::Scalar::unit() * size;
                    prop_assert!(off.abs() <= bound, "off by {off:e} at call {n}");
                }
                let expected = PortSample { velocity: told.velocity, ..drives[n] };
                prop_assert!(*told == expected, "{told:?}");
            }
            Ok(())
        });
    }

    /// A bad call passes through unchanged, and the filter continues from the call before.
    pub(super) fn bad_samples_are_forgotten<V: Port>() {
        hold(
            CASES / 10,
            (any::<Bits>(), vec(uniform16(any::<Bits>()), 3..24)),
            |(bits, samples)| {
                let period = V::Scalar::of(1e-3);
                let sound: Vec<PortSample<V>> =
                    samples.iter().map(|bits| drive_of(*bits, true, period).0).collect();
                let at = 1 + bits as usize % (sound.len() - 1);
                let wrong = bad::<V::Scalar>(bits >> 20);
                let mut spoilt = sound[at];
                spoilt.displacement = V::from_axes(|axis| match axis {
                    0 => wrong,
                    _ => spoilt.displacement.axis(axis),
                });
                let mut drives = sound.clone();
                drives[at] = spoilt;
                let mut without = sound.clone();
                without.remove(at);
                let (clean, whole) =
                    (told(V::Scalar::of(50.0), &without), told(V::Scalar::of(50.0), &sound));
                for (n, told) in told(V::Scalar::of(50.0), &drives).iter().enumerate() {
                    let first = told.velocity.axis(0).f64();
                    prop_assert!(first.is_finite() == (n != at), "{first} at call {n}");
                    if n != at {
                        let like = &clean[if n < at { n } else { n - 1 }];
                        prop_assert!(like.velocity.axis(0).f64() == first, "call {n}");
                    }
                    for axis in 1..V::AXES {
                        prop_assert!(told.velocity.axis(axis) == whole[n].velocity.axis(axis));
                    }
                }
                Ok(())
            },
        );
    }
}

crate::support::every_port!(velocity_is_the_weighted_sum, bad_samples_are_forgotten);

/// Steady motion from rest with `ω T = 1`: every call makes up half of the difference.
#[test]
fn steady_motion_is_approached() {
    let period = 1e-3;
    let drives: Vec<_> = (0..20)
        .map(|n| {
            HeldTick {
                period,
                position: f64::from(n) * 1e-3,
                velocity: 9.0,
                displacement: if n == 0 { 5.0 } else { 1e-3 },
                applied: 0.0,
            }
            .sample()
        })
        .collect();
    for (n, told) in told(1.0 / (TAU * period), &drives).iter().enumerate() {
        assert!(
            abs_diff_eq!(told.velocity, 1.0 - 0.5f64.powi(n as i32), epsilon = 1e-14),
            "call {n}"
        );
    }
}

/// The gain at the cutoff is `1 / √2`, and far above or below it that of `ω / (s + ω)`.
#[test]
fn gain_is_that_of_a_first_order_lag() {
    let (period, cutoff) = (1e-5, 50.0);
    for ratio in [0.1, 1.0, 10.0] {
        let omega = TAU * cutoff * ratio;
        let at = |n: usize| (omega * period * n as f64).sin() / omega;
        let drives: Vec<_> = (0..300_000)
            .map(|n| {
                HeldTick {
                    period,
                    position: at(n),
                    velocity: 0.0,
                    displacement: at(n) - at(n.max(1) - 1),
                    applied: 0.0,
                }
                .sample()
            })
            .collect();
        let told = told(cutoff, &drives);
        let settled = told[100_000..].iter().map(|sample| sample.velocity);
        let gain = settled.fold(0.0, f64::max);
        let expected = 1.0 / (1.0f64 + ratio * ratio).sqrt();
        assert!(
            abs_diff_eq!(gain / expected, 1.0, epsilon = 0.02),
            "{gain} at {ratio} times the cutoff"
        );
    }
}

/// The larger the cutoff, the nearer to the backward difference.
#[test]
fn large_cutoffs_tend_to_the_difference() {
    let drives: Vec<_> = (0..50)
        .map(|n| {
            HeldTick {
                period: 1e-3,
                position: 0.0,
                velocity: 0.0,
                displacement: f64::from(n * n % 7 - 3),
                applied: 0.0,
            }
            .sample()
        })
        .collect();
    let mut last = f64::INFINITY;
    for cutoff in [1e2, 1e4, 1e6, 1e9, 1e13, 1e25, 1e300] {
        let off = told(cutoff, &drives)
            .iter()
            .zip(&drives)
            .skip(1)
            .map(|(told, sample)| (told.velocity - sample.displacement / 1e-3).abs())
            .fold(0.0, f64::max);
        // 6 m in one call, times 1 / (ω T).
        let bound = 6e3 / (TAU * cutoff * 1e-3) + 1e-12;
        assert!(off <= bound && off <= last, "{off:e} at {cutoff:e} Hz");
        last = off;
    }
}

#[test]
fn wrong_cutoffs_are_refused() {
    let spring = Spring::<f32>::new(1.0).expect("a spring");
    for cutoff in [0.0, -1.0, f32::NAN, f32::INFINITY, f32::MAX] {
        let error = spring.low_passed(cutoff).expect_err("a wrong cutoff");
        assert_eq!(error.parameter, "filter cutoff");
        assert!(error.value == f64::from(cutoff) || cutoff.is_nan());
    }
    assert!(spring.low_passed(f32::MIN_POSITIVE).is_ok());
}
