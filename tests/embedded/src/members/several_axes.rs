//! Members for several axes: two axes, or a rigid body.

use lyapunov_core::{Jacobian, ParameterError, PortEnergy, Screw, WorldAxes};
use lyapunov_stabilizers::{
    AlongDirection, AxisWeights, BodyInertia, DampingLimit, DampingMatrix, DirectedDamping,
    ForceBounding, InertiaLimit, InertiaMetric, JointInertia, PartLimits, PerAxis, PerPart, Popc,
    TaskInertia,
};
use nalgebra::{Matrix2, Vector2, Vector3};

use super::{Number, Visit, limit, period, popc};

type Shown = Result<(), ParameterError>;
type Body<T> = Screw<T, WorldAxes>;

/// Directions of the damping.
#[inline(never)]
pub(super) fn metrics<T: Number>(visit: &mut impl Visit<T>) -> Shown {
    let (popc, limit) = (popc::<T>()?, limit::<T>()?);
    let axes = Vector2::new(T::of(0.5), T::of(0.25));
    let weights = AxisWeights::new(axes)?;
    visit.member::<Vector2<T>, _>("popc-weighted", DirectedDamping::new(popc, weights, limit));
    let along = AlongDirection::new(axes)?;
    visit.member::<Vector2<T>, _>("directed-damping", DirectedDamping::new(popc, along, limit));
    let metric = InertiaMetric::new(inertia())?;
    visit.member::<Vector2<T>, _>("popc-inertia", DirectedDamping::new(popc, metric, limit));
    let bounding: ForceBounding<T, DampingMatrix<T, 2>> = ForceBounding::of_matrix(inertia())?;
    visit.member::<Vector2<T>, _>("force-bounding-matrix", bounding);
    Ok(())
}

/// Limits by the inertia of an arm with two joints.
#[inline(never)]
pub(super) fn inertias<T: Number>(visit: &mut impl Visit<T>) -> Shown {
    let unlimited = Popc::new(PortEnergy, DampingLimit::at(T::of(f64::INFINITY))?);
    let (cap, joints) = (T::of(0.5), JointInertia::new(inertia())?);
    let limited = InertiaLimit::new(unlimited, joints, cap, period())?;
    visit.member::<Vector2<T>, _>("popc-inertia-limit", limited);
    let of = |values: [f64; 3]| Vector3::from(values.map(T::of));
    let hinge = |arm: [f64; 3]| Screw::new(of(arm), of([0.0, 0.0, 1.0]));
    let jacobian: Jacobian<T, 2, WorldAxes> =
        Jacobian::of([hinge([-0.3, 0.4, 0.0]), hinge([-0.3, 0.0, 0.0])]);
    let task = TaskInertia::new(&jacobian, inertia())?;
    let limited = InertiaLimit::new(unlimited, task, cap, period())?;
    visit.member::<Body<T>, _>("popc-task-inertia", limited);
    Ok(())
}

/// Axes and parts by themselves.
#[inline(never)]
pub(super) fn apart<T: Number>(visit: &mut impl Visit<T>) -> Shown {
    let (popc, of) = (popc::<T>()?, T::of);
    visit.member::<Vector2<T>, PerAxis<_, 2>>("per-axis", PerAxis::of([popc; 2]));
    let body = BodyInertia { mass: of(0.4), moment: of(2e-4) };
    let limits = PartLimits::of_body(of(0.5), body, period())?;
    let (push, turn) = (limits.translation, limits.rotation);
    let parts = PerPart::of(Popc::new(PortEnergy, push), Popc::new(PortEnergy, turn));
    visit.member::<Body<T>, _>("per-part", parts);
    let unlimited = Popc::new(PortEnergy, DampingLimit::at(of(f64::INFINITY))?);
    visit.member::<Body<T>, _>("popc-within", DirectedDamping::within(unlimited, limits));
    Ok(())
}

/// Symmetric matrix above 0.
fn inertia<T: Number>() -> Matrix2<T> {
    let [one, both, two] = [0.5, 0.1, 0.1].map(T::of);
    Matrix2::new(one, both, both, two)
}
