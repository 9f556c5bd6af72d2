//! Directed damping: the same energy dissipated, in chosen directions.

use approx::assert_abs_diff_eq;
use lyapunov::lanes::AutoF32x4;
use lyapunov::{
    DampingLimit, HeldTick, Popc, PortEnergy, PortSample, Scalar, Stabilizer,
    stabilizers::{AlongDirection, AxisWeights, DirectedDamping, InertiaMetric, Metric},
};
use nalgebra::{Matrix3, SMatrix, SVector, Vector3};

use crate::support::{Dice, PERIOD, limit, popc};

fn sample(velocity: Vector3<f64>, debt: f64) -> PortSample<Vector3<f64>> {
    let work = Vector3::new(-debt, 0.0, 0.0);
    let zero = Vector3::zeros();
    PortSample {
        work,
        ..HeldTick {
            period: PERIOD,
            position: zero,
            velocity,
            displacement: velocity * PERIOD,
            applied: zero,
        }
        .sample()
    }
}

#[test]
fn along_a_direction_and_by_weights() {
    let mut dice = Dice::of(12);
    let direction = Vector3::new(1.0, -2.0, 2.0);
    let weights = Vector3::new(1.0, 0.25, 0.0);
    let along = AlongDirection::new(direction * 1e200).expect("a direction");
    for _ in 0..1000 {
        let velocity: Vector3<f64> = dice.signal(0.5);
        let (sample, effort) = (sample(velocity, 1e-6), dice.signal::<Vector3<f64>>(3.0));
        let burnt = |added: Vector3<f64>| added.dot(&velocity) * PERIOD;

        let mut one = DirectedDamping::new(popc(), along, limit());
        let correction = one.stabilize(&sample, effort);
        let added = correction.effort - effort;
        assert!(added.cross(&direction).norm() < 1e-12);
        assert_abs_diff_eq!(burnt(added) + correction.shortfall, 1e-6, epsilon = 1e-15);
        let told = correction.alpha * velocity.norm_squared() * PERIOD;
        assert_abs_diff_eq!(burnt(added), told, epsilon = 1e-15);

        let mut other =
            DirectedDamping::new(popc(), AxisWeights::new(weights).expect("weights"), limit());
        let correction = other.stabilize(&sample, effort);
        let added = correction.effort - effort;
        let ratio = added.x / velocity.x;
        assert!((added - velocity.component_mul(&weights) * ratio).norm() < 1e-12);
        assert_abs_diff_eq!(burnt(added) + correction.shortfall, 1e-6, epsilon = 1e-15);
    }
}

/// A matrix that is above 0, in random directions: a sum of `c aᵢ aᵢᵀ`.
fn inertia(dice: &mut Dice, scale: f64) -> Matrix3<f64> {
    (0..4).fold(Matrix3::zeros(), |sum, _| {
        let axis: Vector3<f64> = dice.signal(1.0);
        sum + axis * axis.transpose() * scale
    })
}

/// A body with that inertia loses the same share of its speed in every direction: its velocity keeps its direction.
#[test]
fn coupled_axes_are_slowed_in_proportion() {
    let mut dice = Dice::of(13);
    for scale in [1e-150, 1e-3, 1.0, 1e150] {
        for _ in 0..300 {
            let inertia = inertia(&mut dice, scale);
            let metric = InertiaMetric::new(inertia).expect("an inertia");
            let cap = 0.5;
            let most = DampingLimit::of_mass(cap, metric.norm(), PERIOD).expect("a limit");
            let velocity: Vector3<f64> = dice.signal(0.5);
            let energy = 0.5 * velocity.dot(&(inertia * velocity));
            let solve =
                |impulse: Vector3<f64>| inertia.cholesky().expect("above 0").solve(&impulse);

            // A small debt is paid in full, a large one up to the share `cap` of the speed.
            for (debt, paid) in [(0.1 * energy, true), (1e3 * energy, false)] {
                // The stabilizer inside is not what limits.
                let mut free = DirectedDamping::new(
                    Popc::new(PortEnergy, DampingLimit::at(f64::INFINITY).expect("none")),
                    metric,
                    most,
                );
                let correction = free.stabilize(&sample(velocity, debt), Vector3::zeros());
                let slower = solve(correction.effort * PERIOD);
                let share = slower.dot(&velocity) / velocity.norm_squared();
                assert!((slower - velocity * share).norm() < 1e-6 * velocity.norm(), "{scale:e}");
                assert!(share <= cap * (1.0 + 1e-6));
                let burnt = correction.effort.dot(&velocity) * PERIOD;
                assert_abs_diff_eq!(burnt + correction.shortfall, debt, epsilon = 1e-9 * debt);
                assert_eq!(correction.shortfall <= 1e-9 * debt, paid);
            }
        }
    }
}

/// Of a matrix that is diagonal it is the weights, and every lane is its own.
#[test]
fn a_diagonal_is_a_weight_for_each_axis() {
    let (weights, velocity) = (Vector3::new(1.0, 0.25, 0.5), Vector3::new(0.1, -0.2, 0.3));
    let metric = InertiaMetric::new(Matrix3::from_diagonal(&(weights * 8.0))).expect("an inertia");
    assert_eq!(metric.apply(velocity), AxisWeights::new(weights).expect("weights").apply(velocity));
    assert_eq!(metric.norm(), 8.0);

    let of = |lane: usize| inertia(&mut Dice::of(lane as u64), 1.0).map(|entry| entry as f32);
    let lanes = SMatrix::<AutoF32x4, 3, 3>::from_fn(|row, column| {
        AutoF32x4::from([0, 1, 2, 3].map(|lane| of(lane)[(row, column)]))
    });
    let spread = SVector::from_fn(|axis, _| AutoF32x4::of(velocity[axis]));
    let together = InertiaMetric::new(lanes).expect("an inertia").apply(spread);
    for lane in 0..4 {
        let own = velocity.map(|axis| axis as f32);
        let alone = InertiaMetric::new(of(lane)).expect("an inertia").apply(own);
        assert_eq!(together.map(|axis| axis.lane(lane)), alone.map(f64::from));
    }
}

#[test]
fn an_inertia_is_above_nothing_in_every_direction() {
    let of = |matrix: [[f64; 3]; 3]| InertiaMetric::new(Matrix3::from(matrix));
    assert!(of([[1.0, 2.0, 0.0], [2.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).is_err());
    assert!(of([[1.0, 1.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).is_err());
    assert!(of([[1.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 1.0]]).is_err());
    assert!(of([[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]]).is_err());
    for bad in [f64::NAN, f64::INFINITY] {
        assert!(of([[1.0, bad, 0.0], [bad, 1.0, 0.0], [0.0, 0.0, 1.0]]).is_err());
    }
    let error = of([[1.0, 2.0, 0.0], [2.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).unwrap_err().to_string();
    assert!(error.contains("inertia's pivot is -1"), "{error}");
}

/// Where nothing moves along the direction nothing can be burnt, and where little does, no more than the limit.
#[test]
fn what_cannot_be_burnt_is_told() {
    let along = AlongDirection::new(Vector3::z()).expect("a direction");
    let most = DampingLimit::at(10.0).expect("a limit");
    let mut aimed = DirectedDamping::new(popc(), along, most);
    let correction = aimed.stabilize(&sample(Vector3::new(0.1, 0.1, 0.0), 1e-6), Vector3::zeros());
    assert_eq!(
        (correction.effort, correction.alpha, correction.shortfall),
        (Vector3::zeros(), 0.0, 1e-6)
    );
    let correction = aimed.stabilize(&sample(Vector3::new(0.1, 0.1, 1e-3), 0.0), Vector3::zeros());
    assert!((correction.effort - Vector3::new(0.0, 0.0, 1e-2)).norm() < 1e-15);
    assert_abs_diff_eq!(correction.shortfall, 1e-6 - 10.0 * 1e-6 * PERIOD, epsilon = 1e-18);
}

#[test]
fn metrics_are_between_nothing_and_all() {
    assert!(AxisWeights::new(Vector3::new(1.0, 1.1, 0.0)).is_err());
    assert!(AxisWeights::new(Vector3::new(1.0, -0.1, 0.0)).is_err());
    assert!(AxisWeights::new(f64::NAN).is_err());
    assert!(AlongDirection::new(Vector3::<f64>::zeros()).is_err());
    assert!(AlongDirection::new(Vector3::new(1.0, f64::NAN, 0.0)).is_err());
    let unit = AlongDirection::new(Vector3::new(0.0, 3.0, 4.0)).expect("a direction");
    let image = unit.apply(Vector3::new(9.0, 5.0, 10.0));
    assert!((image - Vector3::new(0.0, 6.6, 8.8)).norm() < 1e-14);
}

/// Of any length, however small or large: the metric is a projection.
#[test]
fn a_direction_has_the_length_1() {
    for size in [5e-324, 1e-300, 1.0, 1.7e308] {
        let metric = AlongDirection::new(Vector3::new(size, size, 0.0)).expect("a direction");
        let once = metric.apply(Vector3::new(0.3, 0.1, 0.2));
        assert_abs_diff_eq!(once, Vector3::new(0.2, 0.2, 0.0), epsilon = 1e-15);
        assert_abs_diff_eq!(metric.apply(once), once, epsilon = 1e-15);
    }
    assert!(AlongDirection::new(Vector3::<f64>::zeros()).is_err());
    assert!(AlongDirection::new(Vector3::new(1.0, f64::NAN, 0.0)).is_err());
}
