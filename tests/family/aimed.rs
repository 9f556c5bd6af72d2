//! As much is burnt, where it is wanted.

use lyapunov::{Aimed, Along, DampingLimit, Drive, Metric, Stabilizer, Weights};
use nalgebra::Vector3;

use crate::support::{Dice, PERIOD, limit, popc};

fn drive(velocity: Vector3<f64>, debt: f64) -> Drive<Vector3<f64>> {
    let work = Vector3::new(-debt, 0.0, 0.0);
    let zero = Vector3::zeros();
    Drive { work, ..Drive::new(PERIOD, zero, velocity, velocity * PERIOD, zero) }
}

#[test]
fn along_a_direction_and_by_weights() {
    let mut dice = Dice::of(12);
    let direction = Vector3::new(1.0, -2.0, 2.0);
    let weights = Vector3::new(1.0, 0.25, 0.0);
    let along = Along::new(direction * 1e200).expect("a direction");
    for _ in 0..1000 {
        let velocity: Vector3<f64> = dice.signal(0.5);
        let (drive, effort) = (drive(velocity, 1e-6), dice.signal::<Vector3<f64>>(3.0));
        let burnt = |correction: Vector3<f64>| correction.dot(&velocity) * PERIOD;

        let mut one = Aimed::new(popc(), along, limit());
        let action = one.stabilize(&drive, effort);
        let correction = action.effort - effort;
        assert!(correction.cross(&direction).norm() < 1e-12);
        assert!((burnt(correction) + action.shortfall - 1e-6).abs() < 1e-15);
        let told = action.alpha * velocity.norm_squared() * PERIOD;
        assert!((burnt(correction) - told).abs() < 1e-15);

        let mut other = Aimed::new(popc(), Weights::new(weights).expect("weights"), limit());
        let action = other.stabilize(&drive, effort);
        let correction = action.effort - effort;
        let ratio = correction.x / velocity.x;
        assert!((correction - velocity.component_mul(&weights) * ratio).norm() < 1e-12);
        assert!((burnt(correction) + action.shortfall - 1e-6).abs() < 1e-15);
    }
}

/// Where nothing moves along the direction nothing can be burnt, and where little does, no more than the limit.
#[test]
fn what_cannot_be_burnt_is_told() {
    let along = Along::new(Vector3::z()).expect("a direction");
    let most = DampingLimit::at(10.0).expect("a limit");
    let mut aimed = Aimed::new(popc(), along, most);
    let action = aimed.stabilize(&drive(Vector3::new(0.1, 0.1, 0.0), 1e-6), Vector3::zeros());
    assert_eq!((action.effort, action.alpha, action.shortfall), (Vector3::zeros(), 0.0, 1e-6));
    let action = aimed.stabilize(&drive(Vector3::new(0.1, 0.1, 1e-3), 0.0), Vector3::zeros());
    assert!((action.effort - Vector3::new(0.0, 0.0, 1e-2)).norm() < 1e-15);
    assert!((action.shortfall - (1e-6 - 10.0 * 1e-6 * PERIOD)).abs() < 1e-18);
}

#[test]
fn metrics_are_between_nothing_and_all() {
    assert!(Weights::new(Vector3::new(1.0, 1.1, 0.0)).is_err());
    assert!(Weights::new(Vector3::new(1.0, -0.1, 0.0)).is_err());
    assert!(Weights::new(f64::NAN).is_err());
    assert!(Along::new(Vector3::<f64>::zeros()).is_err());
    assert!(Along::new(Vector3::new(1.0, f64::NAN, 0.0)).is_err());
    let unit = Along::new(Vector3::new(0.0, 3.0, 4.0)).expect("a direction");
    let image = unit.apply(Vector3::new(9.0, 5.0, 10.0));
    assert!((image - Vector3::new(0.0, 6.6, 8.8)).norm() < 1e-14);
}
