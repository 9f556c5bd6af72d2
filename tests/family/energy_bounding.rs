//! The energy-bounding algorithm against its worked rows, its published form, and an adversary.

use lyapunov::lanes::AutoF64x4;
use lyapunov::{HeldTick, Scalar, Stabilizer, stabilizers::EnergyBounding};
use nalgebra::Vector3;

use crate::adversary::{DAMPING, least, least_over};
use crate::support::{Dice, PERIOD, held_tick};
use crate::worked::{A, B, felt, near};

fn of(c1: f64, c2: f64) -> EnergyBounding<f64> {
    EnergyBounding::new(c1, c2).expect("constants")
}

fn rows<T: Scalar>() {
    let (damping, period) = (T::of(DAMPING), T::of(PERIOD));
    let same = || EnergyBounding::<T>::of_damping(damping, period).expect("one");
    let soft = || EnergyBounding::<T>::new(T::of(500.0), T::of(250.0)).expect("one");
    let tight = || EnergyBounding::<T, _>::tight(damping, period).expect("one");
    let row = [0.0, 0.05, 0.15, 0.3, 0.4, 0.4, 0.312311, 0.196465, 0.120451, 0.0704505];
    near(&felt::<T>(same(), A), &row);
    let row = [0.0, 0.05, 0.15, -0.062132, -0.0177302, -0.0177302, 0.0, 0.0, 0.0, 0.0];
    near(&felt::<T>(same(), B), &row);
    let row =
        [0.0, 0.05, 0.120711, 0.217113, 0.272796, 0.272796, 0.22734, 0.164392, 0.121828, 0.0718277];
    near(&felt::<T>(soft(), A), &row);
    let row = [0.0, 0.05, 0.120711, -0.0671129, -0.0336907, -0.0336907, 0.0, 0.0, 0.0, 0.0];
    near(&felt::<T>(soft(), B), &row);
    near(&felt::<T>(tight(), A), &[0.0, 0.1, 0.3, 0.6, 0.8, 0.8, 0.6, 0.3, 0.1, 0.0]);
    near(&felt::<T>(tight(), B), &[0.0, 0.1, 0.3, -0.6, -0.4, -0.4, 0.0, 0.0, 0.2, 0.1]);
}

crate::worked::each_scalar!(the_worked_rows, rows);

/// A damper of 3 N·s/m that moves by 2 mm in 4 ms dissipates 3 N·s/m · (2 mm)² / 4 ms = 3 mJ, whatever `c1` is.
#[test]
fn what_the_damper_of_the_device_dissipates_is_counted() {
    let (damping, period, displacement) = (3.0, 0.004, 0.002);
    let mut bounding = of(500.0, 250.0).on_damping(damping, period).expect("a damping");
    let velocity = displacement / period;
    let tick = HeldTick { period, position: 0.0, velocity, displacement, applied: 0.0 };
    let told = bounding.stabilize(&tick.sample(), 0.0).observed_energy;
    assert!((told - 0.003).abs() < 1e-15, "{told}");
    let mut tight = EnergyBounding::<f64, _>::tight(damping, period).expect("a damping");
    let told = tight.stabilize(&tick.sample(), 0.0).observed_energy;
    assert!((told - 0.003).abs() < 1e-15, "{told}");
}

/// The published form, with its divisions.
fn published(c1: f64, c2: f64, last: f64, asked: f64, moved: f64) -> f64 {
    if moved == 0.0 {
        return last;
    }
    let (slope, ratio) = ((asked - last) / moved, last / moved);
    let root = (c2 * c2 + ratio * ratio).sqrt();
    let (least, most) = (c2 - ratio - root, c2 - ratio + root);
    last + slope.max(least).min(c1.min(most)) * moved
}

#[test]
fn in_forces_it_is_the_published_form() {
    for (c1, c2) in [(500.0, 500.0), (500.0, 250.0), (2000.0, 1.0)] {
        let (mut bounding, mut dice) = (of(c1, c2), Dice::of(3));
        let (mut last, mut position) = (0.0, 0.0);
        for tick in 0..20_000 {
            let moved = if tick % 7 == 0 { 0.0 } else { dice.within(1e-3) };
            position += moved;
            let asked = dice.within(3.0);
            let sample = held_tick(position, moved, last);
            let force = bounding.stabilize(&sample, asked).effort;
            let expected = published(c1, c2, last, asked, moved);
            let size = last.abs() + c1 * moved.abs();
            assert!((force - expected).abs() <= 1e-12 * size, "{force} for {expected}");
            last = force;
        }
    }
}

/// From 1 N a way in of 1 mm may change the force by `c2 Δx − F − √((c2 Δx)² + F²)` at the least, which is −1.781 N for
/// 250 N/m; for a late force by no less than `−c1 Δx` of 500 N/m.
#[test]
fn a_late_force_falls_no_faster_than_it_rises() {
    let fallen = |mut bounding: EnergyBounding<f64>| {
        let mut told = [0.0; 2];
        for (told, (displacement, asked)) in told.iter_mut().zip([(2e-3, 9.0), (1e-3, -9.0)]) {
            *told = bounding.stabilize(&held_tick(0.0, displacement, 0.0), asked).effort;
        }
        assert_eq!(told[0], 1.0);
        told[1] - told[0]
    };
    let at_once = 0.25 - 1.0 - (0.25f64.powi(2) + 1.0).sqrt();
    assert!((fallen(of(500.0, 250.0)) - at_once).abs() < 1e-12);
    assert!((fallen(of(500.0, 250.0).delayed(0).expect("one")) - at_once).abs() < 1e-12);
    assert!((fallen(of(500.0, 250.0).with_bounded_fall()) + 0.5).abs() < 1e-12);
}

/// Port and damper together give nothing, whatever the motion, and the sum that is told is theirs.
#[test]
fn an_adversary_gets_nothing() {
    let rate = DAMPING / PERIOD;
    assert!(least(|| EnergyBounding::of_damping(DAMPING, PERIOD).expect("one"), 0) >= -1e-12);
    assert!(least(|| of(rate, 0.2 * rate), 0) >= -1e-12);
    assert!(least(|| EnergyBounding::tight(DAMPING, PERIOD).expect("one"), 0) >= -1e-12);
    // The constants are the largest.
    assert!(least(|| of(2.0 * rate, 2.0 * rate), 0) < -1e-3);
    assert!(least(|| of(2.0 * rate, rate), 0) < -1e-3);
}

#[test]
fn nor_in_samples_of_up_to_two_periods() {
    let rate = DAMPING / PERIOD;
    let one = || EnergyBounding::of_damping(DAMPING, PERIOD).expect("one");
    assert!(least_over(one, 0, 2.0) >= -1e-12);
    let soft = || of(rate, 0.5 * rate).on_damping(DAMPING, PERIOD).expect("one");
    assert!(least_over(soft, 0, 4.0) >= -1e-12);
    // Neither over longer times, nor where the period is not told.
    assert!(least_over(one, 0, 8.0) < -1e-3 && least_over(soft, 0, 16.0) < -1e-3);
    assert!(least_over(|| of(rate, rate), 0, 2.0) < -1e-3);
}

/// A clock that is late by a rounding finds the law of the period, and not another one.
#[test]
fn a_rounding_of_the_period_changes_no_more_than_roundings() {
    let mut dice = Dice::of(7);
    let mut made = [PERIOD, PERIOD * (1.0 + f64::EPSILON), PERIOD * (1.0 + 1e-9)]
        .map(|period| (period, EnergyBounding::of_damping(DAMPING, PERIOD).expect("one"), 0.0));
    for _ in 0..10_000 {
        let (moved, asked) = (dice.within(1e-4), dice.within(3.0));
        let told = made.each_mut().map(|(period, one, applied)| {
            let tick = HeldTick {
                period: *period,
                position: 0.0,
                velocity: moved / PERIOD,
                displacement: moved,
                applied: *applied,
            };
            *applied = one.stabilize(&tick.sample(), asked).effort;
            *applied
        });
        assert!((told[1] - told[0]).abs() < 1e-9, "{told:?}");
        assert!((told[2] - told[0]).abs() < 1e-5, "{told:?}");
    }
}

/// 10 mm in ten periods of 1 ms: a damper of 0.5 N·s/m dissipates 0.5 N·s/m · (10 mm)² / 10 ms = 5 mJ.
#[test]
fn a_sample_of_several_periods_is_booked_over_its_own() {
    let moved = 0.01;
    let tick = HeldTick {
        period: 10.0 * PERIOD,
        position: moved,
        velocity: moved / (10.0 * PERIOD),
        displacement: moved,
        applied: 0.0,
    };
    let mut one = EnergyBounding::of_damping(DAMPING, PERIOD).expect("one");
    let mut tight = EnergyBounding::<f64, _>::tight(DAMPING, PERIOD).expect("one");
    for told in [one.stabilize(&tick.sample(), 9.0), tight.stabilize(&tick.sample(), 9.0)] {
        assert!((told.observed_energy - 0.005).abs() < 1e-15, "{told:?}");
        assert!(told.effort.abs() <= (2.0 * 1000.0 * 0.005f64).sqrt(), "{told:?}");
    }
}

#[test]
fn late_forces_need_smaller_constants() {
    assert!(least(|| EnergyBounding::of_damping(DAMPING, PERIOD).expect("one"), 1) < -1e-3);
    for late in 0..5 {
        let delayed = || {
            EnergyBounding::of_damping(DAMPING, PERIOD)
                .and_then(|it| it.delayed(late))
                .expect("one")
        };
        let found = least(delayed, late as usize);
        assert!(found >= -1e-12, "{found} at {late} ticks");
    }
}

/// `Σ F Δx + c1 Δx² ≥ (F(n)² − F(0)²) / (2 c2)`, axis by axis.
#[test]
fn the_account_is_above_its_storage() {
    let (c1, c2) = (800.0, 300.0);
    let mut bounding = EnergyBounding::<Vector3<f64>>::new(c1, c2).expect("one");
    let (mut dice, mut force, mut energy) = (Dice::of(5), Vector3::zeros(), 0.0);
    for _ in 0..5000 {
        let (moved, asked): (Vector3<f64>, Vector3<f64>) = (dice.signal(1e-3), dice.signal(2.0));
        energy += force.dot(&moved) + c1 * moved.norm_squared();
        let sample = held_tick(Vector3::zeros(), moved, force);
        let correction = bounding.stabilize(&sample, asked);
        force = correction.effort;
        assert!(
            (correction.observed_energy - energy).abs() <= 1e-12 * energy
                && correction.shortfall == 0.0
        );
        let stored = force.norm_squared() / (2.0 * c2);
        assert!(energy >= stored * (1.0 - 1e-12), "{energy:e} J for {stored:e} J");
    }
}

#[test]
fn small_steps_are_none() {
    for moved in [0.0, 1e-320, -1e-320, 1e-200, -1e-200] {
        let mut bounding = of(500.0, 500.0);
        let pressed = HeldTick {
            period: PERIOD,
            position: 1e-3,
            velocity: 1.0,
            displacement: 1e-3,
            applied: 0.0,
        }
        .sample();
        let force = bounding.stabilize(&pressed, 10.0).effort;
        let step = held_tick(1e-3, moved, force);
        let (up, mut down) = (bounding.stabilize(&step, 10.0).effort, bounding);
        assert!((up - force).abs() < 1e-12 * force, "{up} N after {moved:e} m");
        assert!(down.stabilize(&step, 0.0).effort.is_finite());
    }
}

#[test]
fn what_cannot_be_right_is_refused() {
    let refused = EnergyBounding::<f64>::new(500.0, 501.0).expect_err("c2 above c1").to_string();
    assert_eq!(refused, "energy-bounding c2 is 501.0; it must be at most 500.0");
    let lanes = AutoF64x4::from([600.0, 500.0, 400.0, 300.0]);
    assert!(EnergyBounding::<AutoF64x4>::new(AutoF64x4::of(500.0), lanes).is_err());
    assert!(EnergyBounding::<f64>::new(0.0, 0.0).is_err());
    assert!(EnergyBounding::<f64>::of_damping(f64::NAN, 1e-3).is_err());
    assert!(EnergyBounding::<f64>::of_damping(1.0, 0.0).is_err());
    let slow = EnergyBounding::<f64>::of_damping(1e-308, 1e-3).expect("one");
    assert!(slow.delayed(u32::MAX).is_ok());
    assert!(EnergyBounding::<f64, _>::tight(1e308, 1e-3).is_err());
}
