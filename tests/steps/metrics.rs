//! Inertias, dampings and directions against the inverse of a matrix and whole numbers.

use approx::assert_relative_eq;
use lyapunov::{
    DampingLimit, PortEnergy, PortSample, Stabilizer,
    poses::{Jacobian, Screw, WorldAxes},
    stabilizers::{
        AlongDirection, AxisWeights, DirectedDamping, ForceBounding, Inertia, InertiaMetric,
        JointInertia, Metric, TaskInertia,
    },
};
use nalgebra::{Matrix2, Matrix3, SMatrix, SVector, Vector2, Vector3};

use crate::support::Dice;

/// A matrix that is above 0, and the same with nonsense above its diagonal, which is not read.
fn above_nothing<const N: usize>(dice: &mut Dice) -> (SMatrix<f64, N, N>, SMatrix<f64, N, N>) {
    let some = SMatrix::<f64, N, N>::from_fn(|_, _| dice.within(2.0));
    let whole = some * some.transpose() + SMatrix::identity();
    let told =
        SMatrix::from_fn(|row, column| if row < column { f64::NAN } else { whole[(row, column)] });
    (whole, told)
}

fn is_the_inverse<const N: usize>() {
    let mut dice = Dice::of(N as u64);
    for _ in 0..200 {
        let (whole, told) = above_nothing::<N>(&mut dice);
        let effort = SVector::<f64, N>::from_fn(|_, _| dice.within(3.0));
        let inertia = JointInertia::new(told).expect("an inertia");
        let yields = effort.dot(&(whole.try_inverse().expect("an inverse") * effort));
        assert_relative_eq!(inertia.inverse_square(effort), yields, max_relative = 1e-9);
        let mass = effort.dot(&effort) / yields;
        assert_relative_eq!(inertia.apparent(effort), mass, max_relative = 1e-9);
    }
}

#[test]
fn an_effort_meets_the_inverse_of_the_inertia() {
    is_the_inverse::<1>();
    is_the_inverse::<2>();
    is_the_inverse::<3>();
    is_the_inverse::<5>();
    let pivot = JointInertia::new(Matrix2::new(1.0, 0.0, 2.0, 1.0)).expect_err("refused");
    assert_eq!((pivot.parameter, pivot.value), ("inertia's pivot", -3.0));
}

/// `Λ⁻¹ = J M⁻¹ Jᵀ` of an arm with two joints, for a force and for a torque.
#[test]
fn a_tool_yields_as_the_joints_do() {
    let joints = [
        (Vector3::new(0.0, 0.5, 0.0), Vector3::z()),
        (Vector3::new(-0.25, 0.5, 0.0), Vector3::z()),
    ];
    let jacobian =
        Jacobian::<f64, 2, WorldAxes>::of(joints.map(|(moved, turned)| Screw::new(moved, turned)));
    let inertia = Matrix2::new(0.5, 0.125, 0.125, 0.25);
    let tool = TaskInertia::new(&jacobian, inertia).expect("an inertia");
    let inverse = inertia.try_inverse().expect("an inverse");
    let mut dice = Dice::of(3);
    for _ in 0..100 {
        let (force, torque): (Vector3<f64>, Vector3<f64>) = (dice.signal(2.0), dice.signal(2.0));
        let torques = joints.map(|(moved, turned)| moved.dot(&force) + turned.dot(&torque));
        let torques = Vector2::from(torques);
        let yields = torques.dot(&(inverse * torques));
        let found = tool.inverse_square(Screw::new(force, torque));
        assert_relative_eq!(found, yields, max_relative = 1e-12);
    }
    assert!(TaskInertia::new(&jacobian, Matrix2::zeros()).is_err());
}

/// `Λ v / ‖Λ‖` with the largest absolute row sum.
#[test]
fn a_metric_is_the_momentum_over_the_norm() {
    let inertia = Matrix3::new(4.0, f64::NAN, f64::NAN, -1.0, 2.0, f64::NAN, 0.5, -0.5, 5.0);
    let metric = InertiaMetric::new(inertia).expect("an inertia");
    assert_eq!(metric.norm(), 6.0);
    let found = metric.apply(Vector3::new(6.0, -12.0, 24.0));
    assert_relative_eq!(found, Vector3::new(8.0, -7.0, 21.5), max_relative = 1e-14);
    let empty = InertiaMetric::new(Matrix2::<f64>::zeros()).expect_err("refused");
    assert_eq!((empty.parameter, empty.value), ("inertia's row", 0.0));
    let weights = AxisWeights::new(Vector2::new(0.25, 1.0)).expect("weights");
    assert_eq!(weights.apply(Vector2::new(8.0, -3.0)), Vector2::new(2.0, -3.0));
    for (bad, least) in [(-0.5, true), (1.5, false)] {
        let error = AxisWeights::new(Vector2::new(1.0, bad)).expect_err("refused");
        assert_eq!((error.parameter, error.value), ("weight", bad));
        assert_eq!(error.to_string().contains("at least"), least);
    }
}

/// A direction has any length, also one whose square is out of range.
#[test]
fn a_direction_has_any_length() {
    for size in [1e-320, 1e-200, 1.0, 7.0, 1e200, 1e307] {
        let along = AlongDirection::new(Vector2::new(3.0, -4.0) * size).expect("a direction");
        let image = along.apply(Vector2::new(10.0, 5.0));
        let within = if size < 1e-300 { 1e-3 } else { 1e-14 };
        assert_relative_eq!(image, Vector2::new(1.2, -1.6), max_relative = within);
    }
    for (bad, name) in [
        (Vector2::new(0.0, 0.0), "direction's length"),
        (Vector2::new(1.0, f64::NAN), "direction"),
        (Vector2::new(f64::INFINITY, 1.0), "direction"),
    ] {
        assert_eq!(AlongDirection::new(bad).expect_err("refused").parameter, name);
    }
}

/// A damping matrix burns `Δxᵀ D Δx / T`, and the law for several degrees of freedom is that of one along its axes.
#[test]
fn a_damping_matrix_burns_by_direction() {
    let mut dice = Dice::of(9);
    for _ in 0..200 {
        let (whole, told) = above_nothing::<3>(&mut dice);
        let mut bounding = ForceBounding::of_matrix(told).expect("a damping").keeping();
        let (displacement, wish): (Vector3<f64>, Vector3<f64>) =
            (dice.signal(0.5), dice.signal(1e3));
        let sample = PortSample {
            displacement,
            ..PortSample::starting(0.5, Vector3::zeros(), Vector3::zeros())
        };
        let told = bounding.stabilize(&sample, wish);
        let energy = displacement.dot(&(whole * displacement)) / 0.5;
        assert_relative_eq!(told.observed_energy, energy, max_relative = 1e-12);
        // |F| = √(4 E / (uᵀ (D / T)⁻¹ u)) along the effort.
        let along = wish.normalize();
        let inverse = whole.try_inverse().expect("an inverse");
        let most = (4.0 * energy / (0.5 * along.dot(&(inverse * along)))).sqrt();
        let expected = along * most.min(wish.norm());
        assert_relative_eq!(told.effort, expected, max_relative = 1e-9);
    }
}

/// Along the axes of a body a directed damping serves what is owed, and says by how much.
#[test]
fn a_directed_damping_serves_along_its_metric() {
    let limit = DampingLimit::at(1e3).expect("a limit");
    let metric = InertiaMetric::new(Matrix2::new(3.0, 1.0, 1.0, 1.0)).expect("an inertia");
    let popc = lyapunov::Popc::new(PortEnergy, DampingLimit::at(f64::INFINITY).expect("none"));
    let mut one = DirectedDamping::new(popc, metric, limit);
    let start = PortSample::starting(0.5, Vector2::zeros(), Vector2::new(1.0, 1.0));
    let told =
        one.stabilize(&PortSample { work: Vector2::new(-3.0, 0.0), ..start }, Vector2::zeros());
    // c (4, 2) / 4 over (1, 1) for half a second: 3 J are served by c = 4.
    assert_relative_eq!(told.effort, Vector2::new(4.0, 2.0), max_relative = 1e-12);
    assert!(told.shortfall == 0.0);
}
