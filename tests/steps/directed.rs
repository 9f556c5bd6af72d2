//! Damping along chosen directions: what it tells, and a metric that is changed.

use lyapunov::stabilizers::{AlongDirection, AxisWeights, DirectedDamping};
use lyapunov::{PortSample, Stabilizer};
use nalgebra::{Vector1, Vector2};

use crate::support::{PERIOD, limit, popc};

/// Beside a force of 1 MN a correction loses digits, and the directed one dissipates what is left of it, no less than the
/// plain one: so it tells the damping and the shortfall of the plain one, to the bit.
#[test]
fn a_debt_that_is_served_in_full_is_told_as_by_the_member_inside() {
    let all = AxisWeights::new(Vector1::new(1.0)).expect("weights");
    let mut lost = 0;
    for number in 1..100 {
        let (mut plain, mut directed) = (popc(), DirectedDamping::new(popc(), all, limit()));
        // At a power of two every product below is exact.
        let moving = PortSample::starting(PERIOD, Vector1::new(0.0), Vector1::new(0.125));
        let owes = PortSample { work: Vector1::new(-1e-7 * f64::from(number)), ..moving };
        let effort = Vector1::new(1e6);
        let (plain, directed) = (plain.stabilize(&owes, effort), directed.stabilize(&owes, effort));
        assert_eq!(directed, plain);
        lost += u32::from((plain.effort - effort).x < plain.alpha * 0.125);
    }
    assert!(lost > 10, "{lost}");
}

/// One and the same debt is served along the first axis, then along the second.
#[test]
fn a_metric_is_changed() {
    let along = |x, y| AlongDirection::new(Vector2::new(x, y)).expect("a direction");
    let mut directed = DirectedDamping::new(popc(), along(1.0, 0.0), limit());
    let moving = PortSample::starting(PERIOD, Vector2::zeros(), Vector2::new(0.1, 0.1));
    let owes = PortSample { work: Vector2::new(-1e-6, 0.0), ..moving };
    let first = directed.stabilize(&owes, Vector2::zeros()).effort;
    directed.set_metric(along(0.0, 1.0));
    let second = directed.stabilize(&moving, Vector2::zeros()).effort;
    assert_eq!((first.y, second.x), (0.0, 0.0));
    assert!(first.x > 0.0 && second.y > 0.0, "{first}{second}");
}
