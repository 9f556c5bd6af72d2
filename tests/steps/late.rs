//! Force bounding: what is set aside for forces under way, and what is no free motion.

use approx::assert_relative_eq;
use lyapunov::{
    Correction, PortSample, Snapshot, Stabilizer,
    stabilizers::{Account, ForceBound, ForceBounding, LimitCredit},
};
use nalgebra::{Matrix2, Vector2};

use crate::support::Dice;

const DAMPING: f64 = 0.5; // N·s/m
const PERIOD: f64 = 0.25; // s

fn bound(energy: f64) -> ForceBound<f64> {
    ForceBound::new(DAMPING).and_then(|it| it.budgeted(energy)).expect("a bound")
}

fn rest() -> PortSample<f64> {
    PortSample::starting(PERIOD, 0.0, 0.0)
}

/// `F² T / (4 b)` of each force, the latest first, and `√(4 b (E − what is set aside) / T)` for the next.
#[test]
fn what_a_force_may_take_is_set_aside() {
    let mut late = bound(8.0).delayed::<4>(2).expect("a pipe");
    // 2 N and 4 N may take 0.5 J and 2 J.
    for (asked, costs) in [(2.0, [0.5, 0.0]), (-4.0, [2.0, 0.5])] {
        assert_eq!(late.stabilize(&rest(), asked).effort, asked);
        let (energy, set_aside) = late.state();
        assert_eq!(energy, 8.0);
        for (place, cost) in [costs[0], costs[1], 0.0, 0.0].into_iter().enumerate() {
            assert_relative_eq!(set_aside[place], cost, max_relative = 1e-14);
        }
    }
    // 5.5 J are left: √(4 · 0.5 · 5.5 / 0.25) = √44 N. Then 0.5 J act, and so on.
    assert_relative_eq!(late.stabilize(&rest(), 100.0).effort, 44f64.sqrt(), max_relative = 1e-12);
    let (_, set_aside) = late.state();
    assert_relative_eq!(set_aside[0], 5.5, max_relative = 1e-12);
    assert_relative_eq!(set_aside[1], 2.0, max_relative = 1e-14);
    assert_relative_eq!(late.stabilize(&rest(), 100.0).effort, 2.0, max_relative = 1e-12);
    // A rejected tick sets nothing aside, and moves the others on.
    assert_eq!(late.stabilize(&rest(), f64::NAN).effort, 0.0);
    assert_eq!(late.state().1[0], 0.0);
}

/// A matrix sets `fᵀ D⁻¹ f T / 4` aside.
#[test]
fn a_matrix_sets_aside_by_direction() {
    let damping = Matrix2::new(2.0, 1.0, 1.0, 2.0); // its inverse is (2, −1; −1, 2) / 3
    let made = ForceBounding::of_matrix(damping).map(ForceBounding::keeping);
    let made = made.and_then(|it| it.budgeted(100.0)).and_then(|it| it.delayed::<1>(1));
    for (force, cost) in [([3.0, 0.0], 6.0), ([3.0, 3.0], 6.0), ([3.0, -3.0], 18.0)] {
        let mut one = made.expect("a bound");
        let start = PortSample::starting(1.0, Vector2::zeros(), Vector2::zeros());
        let told = one.stabilize(&start, Vector2::from(force));
        assert_eq!((told.effort, told.observed_energy), (Vector2::from(force), 100.0));
        assert_relative_eq!(one.state().1[0], cost / 4.0, max_relative = 1e-14);
    }
}

/// A limit of the credit leaves what is set aside.
#[test]
fn what_is_set_aside_is_no_credit() {
    let mut late = bound(8.0).delayed::<2>(1).expect("a pipe");
    late.stabilize(&rest(), 4.0);
    late.limit_credit(3.0);
    assert_relative_eq!(late.observed_energy(), 3.0 + 2.0, max_relative = 1e-14);
    late.limit_credit(0.0);
    assert_relative_eq!(late.observed_energy(), 2.0, max_relative = 1e-14);
    late.limit_credit(7.0);
    assert_relative_eq!(late.observed_energy(), 2.0, max_relative = 1e-14);
}

/// The worst motion, `Δx = −F T / (2 b)`, leaves nothing, and no less than nothing in computed numbers.
#[test]
fn the_account_does_not_fall_below_nothing_by_rounding() {
    let mut dice = Dice::of(17);
    for _ in 0..20_000 {
        let energy = dice.within(1.0).abs() * 10f64.powf(dice.within(6.0));
        let mut one = bound(energy);
        let force = one.stabilize(&rest(), f64::from(1u32 << 31)).effort;
        let displacement = -force * PERIOD / (2.0 * DAMPING);
        let worst = PortSample { displacement, work: force * displacement, ..rest() };
        let told = one.stabilize(&worst, 0.0);
        assert!(told.observed_energy >= 0.0 && told.shortfall == 0.0, "{told:?} of {energy:e} J");
        assert!(told.observed_energy <= 64.0 * f64::EPSILON * energy, "{told:?} of {energy:e} J");
    }
}

/// Where no force acted the account is emptied; where it is unknown what acted it is not.
#[test]
fn an_unknown_force_is_no_free_motion() {
    let mut one = ForceBounding::of_damping(DAMPING).expect("a bound");
    let pressed = PortSample { applied: 2.0, work: 3.0, ..rest() };
    assert_eq!(one.stabilize(&pressed, 0.0).observed_energy, 3.0);
    for applied in [f64::NAN, f64::INFINITY] {
        let told = one.stabilize(&PortSample { applied, work: f64::NAN, ..rest() }, 0.0);
        assert_eq!((told.observed_energy, told.accepted), (3.0, false));
    }
    assert_eq!(one.stabilize(&PortSample { applied: -1.0, ..rest() }, 0.0).observed_energy, 3.0);
    assert_eq!(one.stabilize(&rest(), 0.0).observed_energy, 0.0);
    // With a force under way what that may take stays.
    let mut late =
        ForceBounding::of_damping(DAMPING).and_then(|it| it.delayed::<1>(1)).expect("one");
    late.stabilize(&pressed, 2.0);
    assert_relative_eq!(late.stabilize(&rest(), 0.0).observed_energy, 0.5, max_relative = 1e-14);
}

/// `b |Δx|² / T`, and `Δxᵀ D Δx / T`.
#[test]
fn a_damper_burns_the_square_of_the_way() {
    let mut one = ForceBounding::of_damping(DAMPING).expect("a bound");
    let moved = |x, y| {
        let displacement = Vector2::new(x, y);
        let start = PortSample::starting(PERIOD, Vector2::zeros(), Vector2::zeros());
        PortSample { displacement, applied: Vector2::new(1.0, 0.0), ..start }
    };
    assert_eq!(one.stabilize(&moved(3.0, 4.0), Vector2::zeros()).observed_energy, 50.0);
    let matrix = ForceBounding::of_matrix(Matrix2::new(2.0, 99.0, 1.0, 4.0)).expect("a bound");
    let told = matrix.keeping().stabilize(&moved(3.0, 4.0), Vector2::zeros());
    assert_eq!(told.observed_energy, (2.0 * 9.0 + 2.0 * 12.0 + 4.0 * 16.0) / PERIOD);
    // An effort whose size is out of range is no effort.
    let told = bound(1.0).stabilize(&rest(), 1e200);
    assert_eq!((told.effort, told.accepted), (0.0, false));
}

/// Beyond the range of its scalar a bound is smaller than the true one, and the member goes on.
#[test]
fn a_bound_out_of_range_rejects_nothing() {
    let mut member = ForceBound::<f64>::new(300.0).expect("a damping");
    let rest = PortSample::starting(1e-3, 0.0, 0.0);
    let rich = PortSample { work: 1e303, ..rest };
    for sample in [rich, rest, rest] {
        let told: Correction<f64> = member.stabilize(&sample, 1e150);
        assert!(told.accepted && told.effort == 1e150, "{told:?}");
    }
    let mut free: ForceBounding<f64> = ForceBounding::of_damping(0.0).expect("a damping");
    let told: Correction<f64> = free.stabilize(&PortSample { work: 1e307, ..rest }, 1.0);
    assert!(told.accepted && told.effort == 0.0, "{told:?}");
}
