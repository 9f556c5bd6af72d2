//! Dry friction against closed forms, quadrature and numbers of 30 digits.

use approx::{abs_diff_eq, assert_abs_diff_eq};
use proptest::array::uniform8;
use proptest::prelude::any;
use proptest::prop_assert;

use lyapunov::bodies::Transition::{Reverse, Slip, Stick};
use lyapunov::{
    Plant, Scalar,
    bodies::{Body, Friction, Impedance, Stribeck, Transition},
};

use crate::support::{Bits, CASES, Real, hold, log_between, ordinary, unit};

type StickSlipPhase<T> = Friction<Body<T>, T, 2>;

pub(crate) fn law<T: Scalar>(coulomb: f64, breakaway: f64, stribeck_velocity: f64) -> Stribeck<T> {
    let [coulomb, breakaway, stribeck_velocity] =
        [coulomb, breakaway, stribeck_velocity].map(T::of);
    Stribeck { coulomb, breakaway, stribeck_velocity }
}

fn block(
    [mass, damping, stiffness]: [f64; 3],
    period: f64,
    [position, velocity]: [f64; 2],
    law: Stribeck<f64>,
) -> StickSlipPhase<f64> {
    let parts = Impedance { mass, damping, stiffness };
    let body = Body::new(parts, period).expect("a body").starting(position, velocity);
    Friction::new(body, parts, law).expect("friction")
}

/// Every transition of `ticks` periods under `effort`, by its time since the start.
pub(crate) fn transitions<B: lyapunov::bodies::Linear<f64, S>, const S: usize>(
    plant: &mut Friction<B, f64, S>,
    effort: f64,
    ticks: usize,
) -> Vec<(f64, Transition)> {
    let mut all = Vec::new();
    for tick in 0..ticks {
        let sample = plant.advance(effort);
        let last = plant.transitions().last(0);
        all.extend(last.map(|(instant, what)| (tick as f64 * sample.period + instant, what)));
    }
    all
}

/// Sliding freely: `v0 m / F` and `m v0² / (2 F)`, or with damping `m/b ln(1 + b v0 / F)`.
#[test]
fn a_block_stops_when_and_where_it_must() {
    hold(CASES, uniform8(any::<Bits>()), |bits| {
        let (mass, force) = (log_between(bits[0], 0.01, 10.0), log_between(bits[1], 0.1, 10.0));
        let stop = log_between(bits[2], 1e-3, 0.5);
        let period = log_between(bits[3], 1e-3, 1.0);
        let applied = ordinary::<f64>(bits[4], 0.5 * force);
        let damping = if bits[5] % 2 == 0 { 0.0 } else { log_between(bits[5], 1e-2, 1.0) * mass };
        // Against the motion: F sgn v + effort, for a motion forwards.
        let (slow, towards) = (force + applied, if bits[6] % 2 == 0 { 1.0 } else { -1.0 });
        let pace = damping / mass;
        let start = match damping {
            0.0 => slow * stop / mass,
            _ => slow * (pace * stop).exp_m1() / damping,
        };
        let distance = match damping {
            0.0 => 0.5 * start * stop,
            // (eᵖ − 1 − p) / p², without cancellation where p is small.
            _ => {
                let (p, mut term, mut sum) = (pace * stop, 0.5, 0.5);
                for k in 3..40 {
                    term *= p / f64::from(k);
                    sum += term;
                }
                slow / mass * stop * stop * sum
            }
        };
        let law = law(force, force, 0.1);
        let mut plant = block([mass, damping, 0.0], period, [0.0, towards * start], law);
        let ticks = (stop / period) as usize + 2;
        let found = transitions(&mut plant, towards * applied, ticks);
        prop_assert!(found.len() == 1 && found[0].1 == Stick, "{found:?}");
        let (instant, _) = found[0];
        prop_assert!(
            abs_diff_eq!(instant, stop, epsilon = 1e-12),
            "at {instant} instead of {stop}"
        );
        let sample = plant.advance(towards * applied);
        prop_assert!(sample.velocity == 0.0 && sample.displacement == 0.0);
        let off = (sample.position - towards * distance).abs();
        prop_assert!(off < 1e-11 * distance, "{} instead of {distance}", sample.position);
        let burnt = force * distance;
        prop_assert!(abs_diff_eq!(plant.heat(), burnt, epsilon = 1e-11 * burnt));
        Ok(())
    });
}

/// On a spring the turning points come every `π / ω`, each `2 F / k` nearer, until the spring force no longer exceeds
/// `F`; in small periods or in one.
#[test]
fn an_oscillation_loses_two_f_over_k_on_each_swing() {
    hold(CASES / 10, uniform8(any::<Bits>()), |bits| {
        let (mass, stiffness) = (log_between(bits[0], 0.1, 2.0), log_between(bits[1], 100.0, 1e4));
        let swings = 1 + (bits[2] % 16) as usize;
        let (force, rest) = (log_between(bits[3], 0.1, 5.0), ordinary::<f64>(bits[4], 0.1));
        let shift = force / stiffness;
        // From rest at (2 swings + share) F / k the last turn is within ± F / k.
        let share = 0.9 * (2.0 * unit(bits[5]) - 1.0);
        let start = (2.0 * swings as f64 + share) * shift;
        let half = std::f64::consts::PI / (stiffness / mass).sqrt();
        let span = half * (swings as f64 + 0.5);
        let ticks = [1, 7, 100][(bits[6] % 3) as usize];
        let parts = Impedance { mass, damping: 0.0, stiffness };
        let body = Body::new(parts, span / ticks as f64).expect("a body");
        let body = body.resting_at(rest).starting(rest + start, 0.0);
        let mut plant = Friction::new(body, parts, law(force, force, 0.1)).expect("friction");
        let found = transitions(&mut plant, 0.0, ticks);
        if ticks == 100 {
            prop_assert!(found.len() == swings + 1 && found[0] == (0.0, Slip), "{found:?}");
        }
        for (back, &(instant, what)) in
            found.iter().rev().take_while(|(_, what)| *what != Slip).enumerate()
        {
            let turn = (swings - back) as f64;
            let last = back == 0;
            prop_assert!(what == if last { Stick } else { Reverse }, "{found:?}");
            prop_assert!(
                abs_diff_eq!(instant, turn * half, epsilon = 1e-12),
                "{instant} not {}",
                turn * half
            );
        }
        let sample = plant.advance(0.0);
        let end = if swings.is_multiple_of(2) { share } else { -share } * shift;
        let off = (sample.position - (rest + end)).abs();
        prop_assert!(off < 1e-13 * (rest.abs() + start), "{off:e} at {swings}");
        prop_assert!(sample.velocity == 0.0 && sample.displacement == 0.0);
        let path = (0..swings).map(|n| 2.0 * (start - (2 * n + 1) as f64 * shift)).sum::<f64>();
        prop_assert!(abs_diff_eq!(plant.heat() / (force * path), 1.0, epsilon = 1e-11));
        Ok(())
    });
}

/// `∫ f(v) dv` from 0 to `end` by Simpson's rule.
fn integral(end: f64, f: impl Fn(f64) -> f64) -> f64 {
    let panels = 20_000;
    let at = |index: usize| f(end * index as f64 / (2 * panels) as f64);
    let sum: f64 =
        (0..panels).map(|panel| at(2 * panel) + 4.0 * at(2 * panel + 1) + at(2 * panel + 2)).sum();
    sum * end / (6 * panels) as f64
}

/// A block slowed by Stribeck friction alone: `t = ∫ m dv / F(v)` and `x = ∫ m v dv / F(v)`.
#[test]
fn stribeck_friction_stops_a_block_by_quadrature() {
    hold(100, uniform8(any::<Bits>()), |bits| {
        let mass = log_between(bits[0], 0.05, 5.0);
        let (coulomb, spread) = (log_between(bits[1], 0.2, 5.0), log_between(bits[2], 0.1, 20.0));
        let speed = log_between(bits[3], 1e-3, 1.0);
        let start = speed * log_between(bits[4], 0.1, 30.0);
        let force = |v: f64| coulomb + spread * (-(v / speed) * (v / speed)).exp();
        let stop = integral(start, |v| mass / force(v));
        let distance = integral(start, |v| mass * v / force(v));
        let law = law(coulomb, coulomb + spread, speed);
        let ticks = 1 + (bits[5] % 50) as usize;
        let mut plant = block([mass, 0.0, 0.0], 1.1 * stop / ticks as f64, [0.0, -start], law);
        let found = transitions(&mut plant, 0.0, ticks);
        prop_assert!(found.len() == 1 && found[0].1 == Stick, "{found:?}");
        let off = (found[0].0 - stop).abs();
        prop_assert!(off < 1e-12 * stop.max(1.0), "{off:e} of {stop}");
        let sample = plant.advance(0.0);
        prop_assert!(abs_diff_eq!(sample.position / -distance, 1.0, epsilon = 1e-12));
        let kinetic = 0.5 * mass * start * start;
        prop_assert!(abs_diff_eq!(plant.heat() / kinetic, 1.0, epsilon = 1e-12));
        Ok(())
    });
}

/// Energy balance: kinetic and spring energy, the effort's work and the heat, without a damper.
#[test]
fn energy_balances() {
    hold(CASES / 20, uniform8(any::<Bits>()), |bits| {
        let mass = log_between(bits[0], 0.05, 2.0);
        let stiffness = if bits[1] % 4 == 0 { 0.0 } else { log_between(bits[1], 1.0, 1e4) };
        let coulomb = if bits[2] % 5 == 0 { 0.0 } else { log_between(bits[2], 0.01, 2.0) };
        let law = law(
            coulomb,
            coulomb + log_between(bits[3], 0.01, 2.0),
            log_between(bits[4], 1e-3, 0.3),
        );
        let start = [ordinary(bits[5], 0.05), ordinary(bits[6], 0.5)];
        let mut plant = block([mass, 0.0, stiffness], log_between(bits[7], 1e-4, 0.1), start, law);
        let energy = |[x, v]: [f64; 2]| 0.5 * (stiffness * x * x + mass * v * v);
        let (mut now, mut work, mut sum, mut random) = (start, 0.0, 0.0, bits[0]);
        let mut rounding = 0.0;
        for _ in 0..200 {
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            let before = now;
            let heat = plant.heat();
            let sample = plant.advance(ordinary::<f64>(random, 3.0));
            now = [sample.position, sample.velocity];
            let burnt = plant.heat() - heat;
            work += sample.work;
            // Each kind of energy varies by itself.
            sum += sample.work.abs() + burnt + energy([now[0], 0.0]).max(energy([before[0], 0.0]));
            sum += energy([0.0, now[1]]).max(energy([0.0, before[1]]));
            // Both ends of a displacement are positions that have been rounded.
            rounding += f64::EPSILON * (sample.applied * sample.position).abs();
            prop_assert!(burnt >= 0.0);
            let off = (energy(now) + work + plant.heat() - energy(start)).abs();
            prop_assert!(off <= 1e-12 * sum + rounding, "{off:e} J of {sum:e}");
        }
        Ok(())
    });
}

/// A device that static friction holds off the spring's rest does not move by a bit in 100 000 periods, in `f32` too.
fn sticks_exactly<T: Real>() {
    let parts = Impedance { mass: T::of(0.3), damping: T::of(0.2), stiffness: T::of(50.0) };
    let start = T::of(0.0071);
    let body = Body::<T>::new(parts, T::of(1e-3)).expect("a body").starting(start, T::of(0.0));
    let mut plant = Friction::new(body, parts, law(0.3, 0.4, 0.01)).expect("friction");
    for tick in 0..100_000 {
        let effort = T::of(if tick % 2 == 0 { 0.04 } else { -0.7 });
        let sample = plant.advance(effort);
        assert!(sample.position == start && sample.velocity == T::of(0.0));
        assert!(sample.displacement == T::of(0.0) && plant.transitions().count(0) == 0);
    }
    assert!(plant.heat() == T::of(0.0));
    plant.advance(T::of(-0.8));
    assert!(plant.transitions().last(0).next() == Some((0.0, Slip)));
}

#[test]
fn sticks_exactly_f32() {
    sticks_exactly::<f32>();
}

#[test]
fn sticks_exactly_f64() {
    sticks_exactly::<f64>();
}

/// From rest at −60 mm on a spring, with Stribeck friction and damping: `python3 scripts/friction_reference.py`.
#[test]
fn stribeck_friction_agrees_with_30_digits() {
    let events =
        [(0.0, Slip), (0.222_354_106_616_157_68, Reverse), (0.446_089_922_165_632_8, Stick)];
    for ticks in [1, 3, 10, 1000] {
        let law = law(1.0, 2.0, 0.05);
        let mut plant = block([0.5, 0.3, 100.0], 1.0 / ticks as f64, [-0.06, 0.0], law);
        let found = transitions(&mut plant, 0.0, ticks);
        assert!(found.len() == 3, "{found:?}");
        for ((instant, what), (exact, kind)) in found.into_iter().zip(events) {
            assert!(
                what == kind && abs_diff_eq!(instant, exact, epsilon = 1e-12),
                "{instant} not {exact}"
            );
        }
        let (sample, heat) = (plant.start(), 0.149_029_305_591_873_48);
        let off = (sample.position + 0.014_810_254_963_371_123).abs();
        assert!(off < 1e-15 && sample.velocity == 0.0, "{off:e}");
        assert_abs_diff_eq!(plant.heat() / heat, 1.0, epsilon = 1e-13);
    }
}
