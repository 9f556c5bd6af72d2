//! Lost answers: as frequent as requested, and replaced by the policy.

use proptest::array::uniform16;
use proptest::collection::vec;
use proptest::prelude::any;
use proptest::prop_assert;

use lyapunov::{
    OnePort, PortSample, Scalar,
    effects::{Fallback, OnePortExt},
    environments::Spring,
};

use crate::support::{Bits, CASES, Port, Scripted, Spy, bad, drive_of, hold, same_axes, unit};

const POLICIES: [Fallback; 2] = [Fallback::Hold, Fallback::Zero];

/// The efforts that act in place of these, with a check that each was asked for with its own sample.
fn acting<V: Port>(
    probability: f64,
    fallback: Fallback,
    seed: u64,
    drives: &[PortSample<V>],
    efforts: &[V],
) -> Vec<V> {
    let mut spy = Spy::on(Scripted::of(efforts.to_vec()));
    let probability = V::Scalar::of(probability);
    let mut port = (&mut spy).dropped(probability, fallback, |_| seed).expect("a dropout");
    let acting = drives.iter().map(|sample| port.respond(sample)).collect();
    assert!(spy.asked.iter().zip(drives).all(|(asked, sample)| asked == sample));
    assert_eq!(spy.asked.len(), drives.len());
    acting
}

/// The lost ones of `count` answers, which efforts of 1 and [`Fallback::Zero`] show.
fn lost<V: Port>(probability: f64, seed: u64, count: usize) -> Vec<bool> {
    let one = V::from_axes(|_| V::Scalar::of(1.0));
    let still = PortSample::starting(V::Scalar::of(1e-3), V::zero(), V::zero());
    let (drives, efforts) = (vec![still; count], vec![one; count]);
    let acting = acting(probability, Fallback::Zero, seed, &drives, &efforts);
    acting.iter().map(|effort| *effort == V::zero()).collect()
}

mod check {
    use super::*;

    /// At a probability of 0 no bit changes; at 1 nothing arrives.
    pub(super) fn certain_cases<V: Port>() {
        hold(CASES, (any::<Bits>(), vec(uniform16(any::<Bits>()), 1..24)), |(seed, samples)| {
            let of = |bits: &[Bits; 16]| drive_of::<V>(*bits, seed % 2 == 0, V::Scalar::of(1e-3));
            let (drives, efforts): (Vec<_>, Vec<_>) = samples.iter().map(of).unzip();
            for fallback in POLICIES {
                let all = acting(0.0, fallback, seed, &drives, &efforts);
                prop_assert!(all.iter().zip(&efforts).all(|(a, b)| same_axes(*a, *b)));
                let none = acting(1.0, fallback, seed, &drives, &efforts);
                prop_assert!(none.iter().all(|effort| same_axes(*effort, V::zero())));
            }
            Ok(())
        });
    }

    /// The seed alone decides which answers are lost, and the last that arrived, or nothing, acts instead; a NaN is an
    /// answer like any other.
    pub(super) fn policies_do_what_they_say<V: Port>() {
        hold(CASES, (any::<Bits>(), vec(uniform16(any::<Bits>()), 1..24)), |(seed, samples)| {
            let of = |bits: &[Bits; 16]| drive_of::<V>(*bits, true, V::Scalar::of(1e-3));
            let (drives, mut efforts): (Vec<_>, Vec<_>) = samples.iter().map(of).unzip();
            let wrong = seed as usize % efforts.len();
            efforts[wrong] = V::from_axes(|_| bad(seed >> 8));
            let probability = unit(seed);
            let lost = lost::<V>(probability, seed, drives.len());
            let held = acting(probability, Fallback::Hold, seed, &drives, &efforts);
            let zeroed = acting(probability, Fallback::Zero, seed, &drives, &efforts);
            let mut arrived = V::zero();
            for (n, effort) in efforts.iter().enumerate() {
                arrived = if lost[n] { arrived } else { *effort };
                prop_assert!(same_axes(held[n], arrived), "held at call {n}");
                let instead = if lost[n] { V::zero() } else { *effort };
                prop_assert!(same_axes(zeroed[n], instead), "zero at call {n}");
            }
            Ok(())
        });
    }
}

crate::support::every_port!(certain_cases, policies_do_what_they_say);

/// Losses have the requested probability and are independent: their runs are as long as a coin's.
#[test]
fn losses_are_independent() {
    const COUNT: usize = 400_000;
    for (seed, p) in [(0, 0.02), (1, 0.3), (2, 0.5), (3, 0.9)] {
        let lost = lost::<f64>(p, seed, COUNT);
        let near = |happened: usize, expected: f64| {
            let deviation = (COUNT as f64 * expected * (1.0 - expected)).sqrt();
            let off = (happened as f64 - COUNT as f64 * expected) / deviation;
            // Runs overlap, which widens their counts: by (1 + p) / (1 − p) at most.
            assert!(off.abs() < 4.8 * ((1.0 + p) / (1.0 - p)).sqrt(), "{happened} with {p}");
        };
        for length in 1..=4 {
            let runs = lost.windows(length).filter(|run| run.iter().all(|lost| *lost)).count();
            near(runs, p.powi(length as i32));
        }
        for lag in 2..=8 {
            let pairs = lost.iter().zip(&lost[lag..]).filter(|(a, b)| **a && **b).count();
            near(pairs, p * p);
        }
    }
    assert!(lost::<f64>(0.5, 4, 64) != lost::<f64>(0.5, 5, 64), "one stream for two seeds");
}

/// One number per call, whatever the probability: an answer lost with a small one is lost with a larger one too.
#[test]
fn larger_probabilities_lose_the_same_and_more() {
    let least = lost::<f32>(0.1, 9, 10_000);
    let more = lost::<f32>(0.4, 9, 10_000);
    assert!(least.iter().zip(&more).all(|(least, more)| *more || !*least));
    assert!(more.iter().filter(|lost| **lost).count() > least.iter().filter(|lost| **lost).count());
}

/// Within a hold the environment is asked at its own ticks only, and each of its answers lasts for all ticks of the
/// hold.
#[test]
fn a_hold_keeps_what_arrives() {
    const TICKS: usize = 5;
    let lost = lost::<f64>(0.4, 21, 200);
    let mut spy = Spy::on(Spring::new(2.0).expect("a spring"));
    let dropped = (&mut spy).dropped(0.4, Fallback::Hold, |_| 21).expect("a dropout");
    let mut port = dropped.held(TICKS as u32).expect("a hold");
    let mut arrived = 0.0;
    for n in 0..200 * TICKS {
        let position = n as f64;
        let effort = port.respond(&PortSample::starting(1e-3, position, 0.0));
        if n % TICKS == 0 && !lost[n / TICKS] {
            arrived = 2.0 * position;
        }
        assert_eq!(effort, arrived, "at tick {n}");
    }
    assert_eq!(spy.asked.len(), 200);
}

#[test]
fn wrong_probabilities_are_refused() {
    let spring = Spring::<f64>::new(1.0).expect("a spring");
    for probability in [-1e-9, 1.000_001, f64::NAN, f64::INFINITY] {
        let refused = spring.dropped(probability, Fallback::Hold, |_| 0);
        assert_eq!(refused.expect_err("a wrong probability").parameter, "dropout probability");
    }
}
