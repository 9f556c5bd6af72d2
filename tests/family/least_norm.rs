//! The least change: closed forms against the optimum, and the filter against its worked rows.

use lyapunov::{
    Correction, DampingLimit, HeldTick, Mask, PortEnergy, PortSample, Scalar, Stabilizer,
    stabilizers::{Constraint, LeastNorm},
};
use nalgebra::Vector3;

use crate::support::{Dice, PERIOD};
use crate::worked::{A, B, felt, near};

fn numbers<T: Scalar>() {
    let of = |drift: f64, gain: f64| Constraint { drift: T::of(drift), gain: T::of(gain) };
    for (drift, gain, least, sontag) in [
        (-1.0, 2.0, 0.0, -1.56155),
        (3.0, 2.0, -1.5, -4.0),
        (3.0, -2.0, 1.5, 4.0),
        (1.0, 0.5, -2.0, -4.06155),
    ] {
        let (found, universal) = (of(drift, gain).least_norm(), of(drift, gain).sontag());
        assert!(found.feasible.all() && universal.feasible.all());
        near(&[found.input.lane(0), universal.input.lane(0)], &[least, sontag]);
    }
    let none = of(3.0, 0.0);
    for input in [none.least_norm(), none.sontag()] {
        assert!(!input.feasible.any() && input.input == T::of(0.0), "{input:?}");
    }
    assert!(of(-3.0, 0.0).least_norm().feasible.all() && of(0.0, 0.0).sontag().feasible.all());
    assert!(!of(f64::NAN, 1.0).least_norm().feasible.any());
}

crate::worked::each_scalar!(the_worked_numbers, numbers);

/// `a + b · u = −√(a² + |b|⁴)`.
#[test]
fn sontag_meets_it_with_his_margin() {
    let mut dice = Dice::of(1);
    for _ in 0..2000 {
        let power = |dice: &mut Dice| 10f64.powf(dice.within(4.0));
        let (drift, gain) = (dice.within(1.0) * power(&mut dice), dice.within(1.0));
        let gain = Vector3::new(gain, dice.within(1.0), dice.within(1.0)) * power(&mut dice);
        let input = Constraint { drift, gain }.sontag();
        let margin = drift.hypot(gain.norm_squared());
        let found = drift + gain.dot(&input.input);
        assert!((found + margin).abs() <= 1e-12 * margin && input.feasible);
    }
}

/// Nothing that meets the constraint is nearer to what was wished.
#[test]
fn the_filter_is_the_optimum() {
    let mut dice = Dice::of(2);
    for _ in 0..300 {
        let (drift, gain, wished): (f64, Vector3<f64>, Vector3<f64>) =
            (dice.within(2.0), dice.signal(1.0), dice.signal(2.0));
        let weights: Vector3<f64> = dice.signal::<Vector3<f64>>(1.0).map(|it| 0.1 + it.abs());
        let constraint = Constraint { drift, gain };
        let input = constraint.filter(wished, weights).expect("weights").input;
        let distance = |from: Vector3<f64>| {
            let apart = from - wished;
            apart.component_mul(&weights).dot(&apart)
        };
        assert!(drift + gain.dot(&input) <= 1e-12);
        for _ in 0..100 {
            let other = input + dice.signal::<Vector3<f64>>(1e-2);
            let meets = drift + gain.dot(&other) <= 0.0;
            assert!(!meets || distance(other) >= distance(input) - 1e-12);
        }
    }
    let constraint = Constraint { drift: 1.0, gain: Vector3::x() };
    assert!(constraint.filter(Vector3::zeros(), Vector3::zeros()).is_err());
}

fn filter<T: Scalar>(decay: f64) -> LeastNorm<T, PortEnergy> {
    let limit = DampingLimit::at(T::of(100.0)).expect("a limit");
    LeastNorm::new(PortEnergy, limit, T::of(decay)).expect("a filter")
}

fn rows<T: Scalar>() {
    let row = [0.0, 0.5, 1.5, 3.0, 4.0, 4.0, 1.75, -0.583333, -0.291667, -0.291667];
    near(&felt::<T>(filter(1.0), A), &row);
    near(&felt::<T>(filter(1.0), B), &[2.0, 2.0, 2.0, -1.0, -1.0, 3.0, 0.0, 0.0, 2.0, 2.0]);
    let row = [0.0, 0.5, 1.5, 3.0, 4.0, 4.0, 0.875, 0.145833, 0.145833, 0.0];
    near(&felt::<T>(filter(0.5), A), &row);
    near(&felt::<T>(filter(0.5), B), &[2.0, 2.0, 2.0, -1.0, -1.0, 3.0, 0.0, 0.0, 1.0, 1.5]);
}

crate::worked::each_scalar!(the_worked_rows, rows);

/// `L(n+1) ≥ (1 − γ) L(n)` where the next displacement is `v T`, without ever a debt.
#[test]
fn nothing_is_paid_after_the_fact() {
    for decay in [0.1, 0.5, 1.0] {
        let unlimited = DampingLimit::at(f64::INFINITY).expect("a limit");
        let mut filter = LeastNorm::new(PortEnergy, unlimited, decay).expect("a filter");
        let mut dice = Dice::of(9);
        let mut sample = PortSample::starting(PERIOD, Vector3::zeros(), dice.signal(0.2));
        let (mut last, mut size) = (0f64, 0f64);
        for tick in 0..5000 {
            let correction = filter.stabilize(&sample, dice.signal::<Vector3<f64>>(5.0));
            size += sample.work.abs().sum();
            assert!(
                correction.observed_energy >= (1.0 - decay) * last - 1e-13 * size,
                "tick {tick}"
            );
            last = correction.observed_energy;
            let moved = sample.velocity * PERIOD;
            sample = HeldTick {
                period: PERIOD,
                position: Vector3::zeros(),
                velocity: dice.signal(0.2),
                displacement: moved,
                applied: correction.effort,
            }
            .sample();
        }
        assert!(size > 0.0);
    }
}

/// What the limit leaves is told: of a debt, or of what is about to be given.
#[test]
fn what_cannot_be_met_is_told() {
    let mut filter = filter::<f64>(1.0);
    let about_to_give = HeldTick {
        period: PERIOD,
        position: 0.0,
        velocity: -0.01,
        displacement: 0.0,
        applied: 0.0,
    }
    .sample();
    let correction: Correction<f64> = filter.stabilize(&about_to_give, 5.0);
    // 100 · 0.01 N of the 5 N that are too much.
    assert!((correction.shortfall - 4.0 * 0.01 * PERIOD).abs() < 1e-15, "{correction:?}");
    let resting = HeldTick {
        period: PERIOD,
        position: 0.0,
        velocity: 0.0,
        displacement: -1e-4,
        applied: 2.0,
    }
    .sample();
    let correction: Correction<f64> = filter.stabilize(&resting, 0.0);
    assert!((correction.shortfall - 2e-4).abs() < 1e-15 && correction.alpha == 0.0);
    assert!(LeastNorm::new(PortEnergy, DampingLimit::at(1.0).expect("one"), 0.0).is_err());
    assert!(LeastNorm::new(PortEnergy, DampingLimit::at(1.0).expect("one"), 1.5).is_err());
}

/// An effort out of range takes no damping with it, so nothing of the debt is served.
#[test]
fn a_rejected_effort_leaves_the_whole_debt_a_shortfall() {
    let limit = DampingLimit::at(f32::INFINITY).expect("a limit");
    let mut filter = LeastNorm::new(PortEnergy, limit, 1.0).expect("a filter");
    let debt =
        HeldTick { period: 1e-3, position: 0.0, velocity: 1.0, displacement: 1.0, applied: -1e36 };
    let told = filter.stabilize(&debt.sample(), f32::MAX);
    assert_eq!((told.accepted, told.effort, told.alpha), (false, 0.0, 0.0));
    assert_eq!((told.observed_energy, told.shortfall), (-1e36, 1e36));
}

/// A drift whose square is out of range.
#[test]
fn sontag_takes_large_drifts() {
    let constraint = Constraint { drift: 1e20_f32, gain: 1e3_f32 };
    let met = constraint.sontag();
    assert!(met.feasible && met.input <= 2.0 * constraint.least_norm().input * (1.0 - 1e-6));
    let loose = Constraint { drift: -1e20_f32, gain: 1e3_f32 }.sontag();
    assert!(loose.feasible && f32::abs(loose.input) < 1e-10);
}
