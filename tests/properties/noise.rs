//! Noise on positions and what follows from them, of the requested size, and no other change.

use approx::abs_diff_eq;
use proptest::array::uniform16;
use proptest::collection::vec;
use proptest::prelude::any;
use proptest::prop_assert;

use lyapunov::{
    OnePort, PortSample, Scalar,
    effects::{OnePortExt, Random, Source},
    environments::Spring,
};

use crate::support::{
    Bits, CASES, Port, Real, Scripted, Spy, bad, drive_of, hold, log_between, same, same_axes,
};

/// The samples that a port behind the noise receives.
fn told<V: Port>(deviation: V::Scalar, seed: u64, drives: &[PortSample<V>]) -> Vec<PortSample<V>> {
    let mut spy = Spy::on(Scripted::of(Vec::new()));
    let mut port = (&mut spy).noisy(deviation, |_| seed).expect("noise");
    for sample in drives {
        port.respond(sample);
    }
    spy.asked
}

fn drives<V: Port>(tame: bool, samples: &[[Bits; 16]]) -> Vec<PortSample<V>> {
    samples.iter().map(|bits| drive_of(*bits, tame, V::Scalar::of(1e-3)).0).collect()
}

mod check {
    use super::*;

    /// A deviation of 0 changes no bit of any sample, also over several periods.
    pub(super) fn zero_deviation_changes_nothing<V: Port>() {
        let samples = vec(uniform16(any::<Bits>()), 2..24);
        hold(CASES, (any::<Bits>(), samples), |(seed, samples)| {
            let mut drives = drives::<V>(seed % 2 == 0, &samples);
            let earlier = drives[0];
            drives[1] = drives[1].spanning(&earlier);
            for (told, sample) in told(V::Scalar::of(0.0), seed, &drives).iter().zip(&drives) {
                prop_assert!(same(told.period.f64(), sample.period.f64()));
                prop_assert!(same_axes(told.position, sample.position));
                prop_assert!(same_axes(told.velocity, sample.velocity));
                prop_assert!(same_axes(told.displacement, sample.displacement));
                prop_assert!(same_axes(told.applied, sample.applied));
                prop_assert!(same_axes(told.work, sample.work));
            }
            Ok(())
        });
    }

    /// `xm = x + deviation · z` with the documented numbers, the displacement between them, and the work over it.
    pub(super) fn positions_carry_the_noise<V: Port>() {
        let samples = vec(uniform16(any::<Bits>()), 1..24);
        hold(CASES, (any::<Bits>(), samples), |(seed, samples)| {
            let drives = drives::<V>(true, &samples);
            let deviation = V::Scalar::of(log_between(seed, 1e-9, 1.0));
            let mut random = Random::new(|_| seed, Source::Noise);
            let mut before = None;
            for (told, sample) in told(deviation, seed, &drives).iter().zip(&drives) {
                let position = sample.position + random.normal::<V>().scale(deviation);
                let displacement = position - before.unwrap_or(position);
                before = Some(position);
                let work = sample.applied.times(displacement);
                let expected = PortSample { position, displacement, work, ..*sample };
                prop_assert!(*told == expected, "{told:?} for {expected:?}");
            }
            Ok(())
        });
    }

    /// Work that other efforts did within a sample of several periods stays in the work.
    pub(super) fn work_of_other_efforts_is_kept<V: Port>() {
        let samples = vec(uniform16(any::<Bits>()), 3);
        hold(CASES, (any::<Bits>(), samples), |(seed, samples)| {
            let [first, earlier, later] = drives::<V>(true, &samples)[..] else { unreachable!() };
            let told = told(V::Scalar::of(1e-3), seed, &[first, later.spanning(&earlier)]);
            for axis in 0..V::AXES {
                let of = |signal: V| signal.axis(axis).f64();
                // The earlier effort over its own displacement, the later one over the rest of the measured one.
                let rest = of(told[1].displacement) - of(earlier.displacement);
                let exact =
                    of(earlier.applied) * of(earlier.displacement) + of(later.applied) * rest;
                let off = (of(told[1].work) - exact).abs();
                prop_assert!(off <= 64.0 * V::Scalar::unit(), "off by {off:e} J");
            }
            Ok(())
        });
    }

    /// A bad position passes in its place and in the next displacement; noise and all else continue.
    pub(super) fn bad_positions_pass<V: Port>() {
        let samples = vec(uniform16(any::<Bits>()), 4..24);
        hold(CASES / 10, (any::<Bits>(), samples), |(seed, samples)| {
            let sound = drives::<V>(true, &samples);
            let at = 1 + seed as usize % (sound.len() - 1);
            let mut spoilt = sound.clone();
            spoilt[at].position = V::from_axes(|axis| match axis {
                0 => bad(seed >> 8),
                _ => sound[at].position.axis(axis),
            });
            let told = |drives: &[PortSample<V>]| told(V::Scalar::of(1e-4), seed, drives);
            for (n, (told, clean)) in told(&spoilt).iter().zip(told(&sound)).enumerate() {
                prop_assert!(told.position.all_finite() == (n != at));
                prop_assert!(told.displacement.all_finite() == (n != at && n != at + 1));
                if n != at && n != at + 1 {
                    prop_assert!(*told == clean, "{told:?}");
                }
            }
            Ok(())
        });
    }
}

crate::support::every_port!(
    zero_deviation_changes_nothing,
    positions_carry_the_noise,
    work_of_other_efforts_is_kept,
    bad_positions_pass,
);

/// The noise at a port has the requested deviation, is white and does not depend on the motion.
#[test]
fn noise_has_the_requested_deviation() {
    let (count, deviation) = (200_000, 2e-5);
    let drives: Vec<PortSample<f64>> =
        (0..count).map(|n| PortSample::starting(1e-3, (f64::from(n) * 0.01).sin(), 0.0)).collect();
    let noise: Vec<f64> = told(deviation, 3, &drives)
        .iter()
        .zip(&drives)
        .map(|(told, sample)| (told.position - sample.position) / deviation)
        .collect();
    let bound = 4.8 * f64::from(count).sqrt();
    let total = |terms: &mut dyn Iterator<Item = f64>| terms.sum::<f64>();
    assert!(total(&mut noise.iter().copied()).abs() < bound);
    assert!(total(&mut noise.iter().map(|z| z * z - 1.0)).abs() < 2f64.sqrt() * bound);
    assert!(total(&mut noise.windows(2).map(|z| z[0] * z[1])).abs() < bound);
    let with_motion = noise.iter().zip(&drives).map(|(z, sample)| z * sample.position);
    assert!(total(&mut with_motion.into_iter()).abs() < bound);
}

/// Noise comes before the encoder: positions are counts, and a small noise moves some by one.
#[test]
fn noise_comes_before_the_counts() {
    let resolution = 2f64.powi(-14);
    let mut spy = Spy::on(Spring::new(1.0).expect("a spring"));
    let encoded = (&mut spy).encoded(resolution).expect("an encoder");
    let mut port = encoded.noisy(0.1 * resolution, |_| 1).expect("noise");
    for _ in 0..10_000 {
        // At 0.4 of a count, 0.1 below the edge: one deviation of the noise.
        port.respond(&PortSample::starting(1e-3, 0.4 * resolution, 0.0));
    }
    let counts: Vec<f64> = spy.asked.iter().map(|sample| sample.position / resolution).collect();
    assert!(counts.iter().all(|count| [0.0, 1.0].contains(count)));
    // One sixth of the normal distribution lies above one deviation: 0.158655.
    let above = counts.iter().sum::<f64>() / 1e4;
    assert!(
        abs_diff_eq!(above, 0.158_655, epsilon = 4.0 * (0.158_655f64 * 0.841_345 / 1e4).sqrt()),
        "{above}"
    );
}

#[test]
fn wrong_deviations_are_refused() {
    let spring = Spring::<f64>::new(1.0).expect("a spring");
    for deviation in [-1e-9, f64::NAN, f64::INFINITY] {
        let error = spring.noisy(deviation, |_| 0).expect_err("a wrong deviation");
        assert_eq!(error.parameter, "noise deviation");
    }
}
