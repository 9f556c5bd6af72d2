//! The force-bounding approach against its worked rows and an adversary, on time and late.

use std::f64::consts::SQRT_2;

use lyapunov::{
    HeldTick, PortSample, Scalar, Stabilizer,
    stabilizers::ForceBound,
    stabilizers::{EnergyBounding, ForceBounding},
};
use nalgebra::{Matrix2, Matrix3, Vector2, Vector3};

use crate::adversary::{DAMPING, least};
use crate::support::{Dice, PERIOD, held_tick};
use crate::worked::{A, B, felt, near};

fn published() -> ForceBounding<f64> {
    ForceBounding::of_damping(DAMPING).expect("one")
}

fn rows<T: Scalar>() {
    let bounding = || ForceBounding::of_damping(T::of(DAMPING)).expect("one");
    near(&felt::<T>(bounding(), A), &[0.0, 0.1, 0.3, 0.6, 0.8, 0.8, 0.6, 0.3, 0.1, 0.0]);
    near(&felt::<T>(bounding(), B), &[0.0, 0.1, 0.3, -0.6, -0.4, 0.4, 0.0, 0.0, 0.2, 0.1]);
    let kept = || ForceBound::new(T::of(DAMPING)).and_then(|it| it.budgeted(T::of(1e-4)));
    let row =
        [0.0, 0.458258, 0.658258, 0.958258, 1.15826, 1.15826, 0.958258, 0.658258, 0.458258, 0.0];
    near(&felt::<T>(kept().expect("one"), A), &row);
    let row =
        [0.447214, 0.547214, 0.747214, -1.0, -0.858287, 0.858287, 0.0, 0.0, 0.750561, 0.650561];
    near(&felt::<T>(kept().expect("one"), B), &row);
}

crate::worked::each_scalar!(the_worked_rows, rows);

/// `E = 1 mJ` over `D = diag(0.5, 2)`.
#[test]
fn each_direction_has_its_damping() {
    let damping = Matrix2::new(0.5, 0.0, 0.0, 2.0);
    let bounding = ForceBounding::of_matrix(damping).map(ForceBounding::keeping);
    let mut bounding = bounding.and_then(|it| it.budgeted(1e-3)).expect("one");
    for (direction, most) in [
        (Vector2::new(1.0, 0.0), SQRT_2),
        (Vector2::new(0.0, 1.0), 2.82843),
        (Vector2::new(0.6, 0.8), 1.96116),
    ] {
        let start = PortSample::starting(PERIOD, Vector2::zeros(), Vector2::zeros());
        let force = bounding.stabilize(&start, direction * 100.0).effort;
        assert!((force - direction * most).norm() < 1e-5, "{force}");
    }
}

/// A matrix leaves 0 at the bound where the motion is the worst, `Δx = −D⁻¹ F T / 2`, and more elsewhere.
#[test]
fn a_matrix_is_kept_and_tight() {
    let damping = Matrix3::new(0.5, 0.1, 0.0, 0.1, 0.4, -0.2, 0.0, -0.2, 0.9);
    let inverse = damping.try_inverse().expect("a damping");
    for share in [1.0, 0.3] {
        let mut bounding = ForceBounding::of_matrix(damping).expect("one");
        let mut dice = Dice::of(6);
        let (mut sample, mut least) =
            (PortSample::starting(PERIOD, Vector3::zeros(), Vector3::zeros()), 0f64);
        let (mut energy, mut emptied) = (0.0, 0);
        for _ in 0..2000 {
            let wish: Vector3<f64> = dice.signal(50.0);
            let force = bounding.stabilize(&sample, wish).effort;
            let worst = inverse * force * (-PERIOD / 2.0) * share;
            let moved = if dice.within(1.0) > 0.0 { worst } else { dice.signal(1e-4) };
            let before = energy;
            energy += force.dot(&moved) + moved.dot(&(damping * moved)) / PERIOD;
            least = least.min(energy);
            emptied += i32::from(moved == worst && energy < 1e-9 * before);
            sample = held_tick(Vector3::zeros(), moved, force);
        }
        assert!(least >= -1e-15, "{least:e} J");
        assert_eq!(emptied > 0, share == 1.0);
    }
}

#[test]
fn an_adversary_gets_nothing_on_time_or_late() {
    assert!(least(published, 0) >= -1e-12);
    assert!(least(|| published().keeping(), 0) >= -1e-12);
    for late in 0..=4 {
        let delayed = || published().delayed::<4>(late).expect("a pipe");
        assert!(least(delayed, late as usize) >= -1e-12, "{late} ticks");
        let kept = || published().keeping().delayed::<4>(late).expect("a pipe");
        assert!(least(kept, late as usize) >= -1e-12, "{late} ticks");
    }
    // What is under way must be set aside.
    assert!(least(published, 1) < -1e-3);
}

/// Free motion buys nothing: a first touch is bounded by `2 b |v|`.
#[test]
fn a_first_touch_is_bounded_by_its_speed() {
    let mut bounding = published();
    let mut force = 0.0;
    for tick in 0..100 {
        let moved = 0.2 * PERIOD;
        let wish = if tick < 99 { 0.0 } else { 1e3 };
        let sample = HeldTick {
            period: PERIOD,
            position: 0.0,
            velocity: 0.2,
            displacement: moved,
            applied: force,
        }
        .sample();
        force = bounding.stabilize(&sample, wish).effort;
    }
    assert!((force - 2.0 * DAMPING * 0.2).abs() < 1e-12, "{force} N");
}

/// The tight energy bounding throws `E − F² / (2 c)` away on each tick; with the same past this allows as much or more.
#[test]
fn it_contains_the_tight_energy_bounding() {
    for seed in 0..50 {
        let mut dice = Dice::of(seed);
        let mut tight = EnergyBounding::tight(DAMPING, PERIOD).expect("one");
        let mut bounding = published();
        let (mut force, mut position) = (0.0, 0.0);
        for _ in 0..200 {
            let moved = dice.within(3e-4);
            position += moved;
            let sample = held_tick(position, moved, force);
            let wish = dice.within(1.0);
            force = tight.stabilize(&sample, wish).effort;
            let most = bounding.stabilize(&sample, 1e6).effort;
            assert!(most >= force.abs() * (1.0 - 1e-12), "{most} N for {force} N");
        }
    }
}

#[test]
fn what_cannot_be_right_is_refused() {
    assert!(ForceBounding::of_damping(-1.0).is_err());
    let wrong = ForceBounding::of_matrix(Matrix2::new(1.0, 2.0, 2.0, 1.0)).expect_err("it is not");
    assert_eq!(wrong.to_string(), "device damping's pivot is -3.0; it must be above 0 and finite");
    assert!(published().delayed::<4>(5).is_err());
    assert!(published().keeping().budgeted(f64::NAN).is_err());
}
