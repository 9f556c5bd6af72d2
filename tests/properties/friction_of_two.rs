//! Dry friction on a device that hangs on a moving operator, with slip instants within a period.

use approx::abs_diff_eq;
use proptest::array::uniform8;
use proptest::prelude::any;
use proptest::prop_assert;

use lyapunov::bodies::Transition::{Reverse, Slip, Stick};
use lyapunov::{
    Plant,
    bodies::{Friction, Impedance, Stribeck, Transition},
};

use crate::friction::{law, transitions};
use crate::support::{Bits, CASES, TwoMasses, hold, log_between, ordinary};

type FrictionBody = Friction<TwoMasses, f64, 4>;

fn impedance(mass: f64, damping: f64, stiffness: f64) -> Impedance<f64> {
    Impedance { mass, damping, stiffness }
}

fn with_friction(body: TwoMasses, law: Stribeck<f64>) -> FrictionBody {
    Friction::new(body, body.parts, law).expect("friction")
}

/// An operator on `x₁ = A sin ωt` pulls a device that sticks with `k x₁`: it slips at `asin(static / (k A)) / ω`, and
/// not at all if the pull ends below static friction, however closely.
#[test]
fn a_pull_slips_when_it_exceeds_static_friction() {
    hold(CASES / 10, uniform8(any::<Bits>()), |bits| {
        let (mass, link) = (log_between(bits[0], 0.05, 2.0), log_between(bits[1], 50.0, 5000.0));
        let spring = log_between(bits[2], 1.0, 500.0);
        let pace = ((spring + link) / mass).sqrt();
        let amplitude = log_between(bits[3], 1e-3, 0.1);
        let sense = if bits[4] % 2 == 0 { 1.0 } else { -1.0 };
        let short = log_between(bits[5], 1e-13, 0.5);
        let period = [1.0, 0.61, 0.083, 0.013][(bits[6] % 4) as usize] * 2.0 / pace;
        let parts =
            [impedance(mass, 0.0, spring), impedance(0.0, 0.0, link), impedance(0.3, 0.0, 0.0)];
        let state = [0.0, sense * amplitude * pace, 0.0, 0.0];
        let body = TwoMasses { parts, period, rest: 0.0, state };
        let ticks = (2.0 / pace / period) as usize + 1;
        let below = link * amplitude * (1.0 - short);
        let mut plant = with_friction(body, law(0.9 * below, below, 0.01));
        let first = transitions(&mut plant, 0.0, ticks).into_iter().next();
        let slip = (1.0 - short).asin() / pace;
        // Near its top a sine is flat: the slope magnifies an error in the pull.
        let blunt = 1e-13 / pace / (2.0 * short).sqrt();
        let found = matches!(first, Some((at, Slip)) if (at - slip).abs() < blunt.max(1e-13));
        prop_assert!(found, "{first:?} instead of {slip} within {blunt:e}");
        let above = link * amplitude * (1.0 + short);
        let mut plant = with_friction(body, law(0.9 * above, above, 0.01));
        prop_assert!(transitions(&mut plant, 0.0, ticks).is_empty());
        Ok(())
    });
}

/// References by `python3 scripts/friction_reference.py`: 30 digits.
fn reference(
    law: Stribeck<f64>,
    ticks: usize,
    events: &[(f64, Transition)],
    end: [f64; 4],
    heat: f64,
) {
    let parts = [impedance(0.1, 0.2, 50.0), impedance(0.0, 0.1, 300.0), impedance(0.2, 0.01, 0.0)];
    let period = 0.3 / ticks as f64;
    let body = TwoMasses { parts, period, rest: 0.0, state: [-0.004, 0.5, -0.004, 0.0] };
    let mut plant = with_friction(body, law);
    let found = transitions(&mut plant, 0.1, ticks);
    if ticks > 1 {
        assert!(found.len() == events.len(), "{found:?}");
    }
    let last = &events[events.len() - found.len()..];
    for (&(instant, what), &(exact, kind)) in found.iter().zip(last) {
        assert!(
            what == kind && abs_diff_eq!(instant, exact, epsilon = 1e-12),
            "{instant} instead of {exact}"
        );
    }
    let sample = plant.start();
    assert!(
        abs_diff_eq!(sample.position, end[2], epsilon = 1e-14),
        "{} not {}",
        sample.position,
        end[2]
    );
    assert!(
        abs_diff_eq!(sample.velocity, end[3], epsilon = 1e-12),
        "{} not {}",
        sample.velocity,
        end[3]
    );
    assert!(abs_diff_eq!(plant.heat() / heat, 1.0, epsilon = 1e-12), "{} not {heat}", plant.heat());
}

#[test]
fn coulomb_friction_agrees_with_30_digits() {
    let events = [
        (0.003695878282740255, Slip),
        (0.07039359022695513, Reverse),
        (0.10841031880775358, Reverse),
        (0.14959754145857168, Reverse),
        (0.20749827673602905, Reverse),
        (0.23058352956343847, Stick),
        (0.24320659742128495, Slip),
        (0.2933342238435611, Stick),
    ];
    let end = [0.0010732150965849143, 0.06475708128807466, -0.0005297790041435623, 0.0];
    for ticks in [1, 4, 30, 300] {
        reference(law(0.5, 0.5, 0.01), ticks, &events, end, 0.008326922704205236);
    }
}

#[test]
fn stribeck_friction_agrees_with_30_digits() {
    let events = [
        (0.004382249580937938, Slip),
        (0.0732181176671643, Reverse),
        (0.10887196319607982, Reverse),
        (0.15177118740875425, Reverse),
        (0.21191609426347682, Reverse),
        (0.22622906174390886, Stick),
        (0.23621424925254447, Slip),
        (0.2986495254300227, Reverse),
    ];
    let end = [
        0.00046852477186148434,
        -0.025751164474456238,
        -0.0027188054745816946,
        0.0017681010234898633,
    ];
    for ticks in [1, 4, 30, 300] {
        reference(law(0.3, 0.6, 0.01), ticks, &events, end, 0.00688421517512366);
    }
}

/// Without dampers every joule is accounted for, and a stuck device keeps its place to the bit while the operator
/// moves.
#[test]
fn energy_balances_and_a_stuck_device_stays() {
    hold(CASES / 20, uniform8(any::<Bits>()), |bits| {
        let parts = [
            impedance(log_between(bits[0], 0.05, 1.0), 0.0, log_between(bits[1], 1.0, 200.0)),
            impedance(0.0, 0.0, log_between(bits[2], 20.0, 5000.0)),
            impedance(log_between(bits[3], 0.05, 1.0), 0.0, 0.0),
        ];
        let state = [bits[4], bits[5], bits[6], bits[7]].map(|bits| ordinary::<f64>(bits, 0.05));
        let period = log_between(bits[6], 1e-4, 0.02);
        let mut shadow = TwoMasses { parts, period, rest: 0.01, state };
        let coulomb = log_between(bits[7], 0.01, 1.0);
        let law =
            law(coulomb, coulomb * log_between(bits[4], 1.0, 3.0), log_between(bits[5], 1e-3, 0.1));
        let mut plant = with_friction(shadow, law);
        let start = shadow.energy();
        let (mut work, mut sum, mut random) = (0.0, 0.0, bits[0]);
        for _ in 0..100 {
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            let (before, heat) = (plant.start(), plant.heat());
            let sample = plant.advance(ordinary::<f64>(random, 1.0));
            shadow.state = plant.body().state;
            work += sample.work;
            sum += sample.work.abs() + (plant.heat() - heat) + 4.0 * shadow.energy();
            let off = (shadow.energy() + work + plant.heat() - start).abs();
            prop_assert!(off <= 1e-12 * sum.max(start), "{off:e} J of {sum:e}");
            prop_assert!(plant.heat() >= heat);
            let quiet = plant.transitions().count(0) == 0;
            if before.velocity == 0.0 && sample.velocity == 0.0 && quiet {
                prop_assert!(sample.position.to_bits() == before.position.to_bits());
            }
        }
        Ok(())
    });
}
