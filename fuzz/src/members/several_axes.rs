//! Members for several axes: two axes, or a rigid body.

use lyapunov_core::{Jacobian, PortEnergy, Screw, WorldAxes};
use lyapunov_stabilizers::{
    AlongDirection, AxisWeights, BodyInertia, DampingLimit, DampingMatrix, DirectedDamping,
    ForceBounding, InertiaLimit, InertiaMetric, JointInertia, PartLimits, PerAxis, PerPart, Popc,
    TaskInertia,
};
use nalgebra::{Matrix2, Vector2};

use super::{Member, limit, popc};
use crate::check::Manner::{Holds, Reduces, Rejects, Shapes};
use crate::drive::stored;
use crate::tick::signal;
use crate::{Bytes, Real};

type Two<T> = Vector2<T>;
type Body<T> = Screw<T, WorldAxes>;

/// Adds all of them.
pub(super) fn list<T: Real>(members: &mut Vec<Member>) {
    metrics::<T>(members);
    inertias::<T>(members);
    apart::<T>(members);
}

fn metrics<T: Real>(members: &mut Vec<Member>) {
    members.push(Member {
        name: "popc-weighted",
        run: |bytes| {
            let (popc, limit) = (popc::<T>(bytes)?, limit(bytes)?);
            let most = popc.limit().most();
            let weights = Two::from_fn(|_, _| T::of(f64::from(bytes.byte()) / 250.0));
            let weights = AxisWeights::new(weights)?;
            let member = DirectedDamping::new(popc, weights, limit);
            stored::<Two<T>, _>(bytes, Shapes(most), Ok(member))
        },
    });
    members.push(Member {
        name: "directed-damping",
        run: |bytes| {
            let (popc, limit) = (popc::<T>(bytes)?, limit(bytes)?);
            let along = AlongDirection::new(signal::<Two<T>>(bytes))?;
            let member = DirectedDamping::new(popc, along, limit);
            stored::<Two<T>, _>(bytes, Rejects, Ok(member))
        },
    });
    members.push(Member {
        name: "popc-inertia",
        run: |bytes| {
            let (popc, limit) = (popc::<T>(bytes)?, limit(bytes)?);
            let metric = InertiaMetric::new(inertia(bytes))?;
            let member = DirectedDamping::new(popc, metric, limit);
            stored::<Two<T>, _>(bytes, Rejects, Ok(member))
        },
    });
    members.push(Member {
        name: "force-bounding-matrix",
        run: |bytes| {
            let member: Result<ForceBounding<T, DampingMatrix<T, 2>>, _> =
                ForceBounding::of_matrix(inertia(bytes));
            stored::<Two<T>, _>(bytes, Reduces, member)
        },
    });
}

fn inertias<T: Real>(members: &mut Vec<Member>) {
    members.push(Member {
        name: "popc-inertia-limit",
        run: |bytes| {
            let (popc, joints) = (popc::<T>(bytes)?, JointInertia::new(inertia(bytes))?);
            let (cap, period) = (bytes.parameter(), bytes.positive());
            stored::<Two<T>, _>(bytes, Rejects, InertiaLimit::new(popc, joints, cap, period))
        },
    });
    members.push(Member {
        name: "popc-task-inertia",
        run: |bytes| {
            let jacobian: Jacobian<T, 2, WorldAxes> = Jacobian::of([signal(bytes), signal(bytes)]);
            let (popc, task) = (popc::<T>(bytes)?, TaskInertia::new(&jacobian, inertia(bytes))?);
            let (cap, period) = (bytes.parameter(), bytes.positive());
            stored::<Body<T>, _>(bytes, Rejects, InertiaLimit::new(popc, task, cap, period))
        },
    });
}

fn apart<T: Real>(members: &mut Vec<Member>) {
    members.push(Member {
        name: "per-axis",
        run: |bytes| {
            let axes = PerAxis::of([popc::<T>(bytes)?, popc(bytes)?]);
            stored::<Two<T>, _>(bytes, Holds, Ok(axes))
        },
    });
    members.push(Member {
        name: "per-part",
        run: |bytes| {
            let parts = PerPart::of(popc::<T>(bytes)?, popc::<T>(bytes)?);
            stored::<Body<T>, _>(bytes, Holds, Ok(parts))
        },
    });
    members.push(Member {
        name: "popc-within",
        run: |bytes| {
            let body = BodyInertia { mass: bytes.positive(), moment: bytes.positive() };
            let limits = PartLimits::of_body(bytes.parameter(), body, bytes.positive())?;
            let unlimited = Popc::new(PortEnergy, DampingLimit::at(T::of(f64::INFINITY))?);
            let member = DirectedDamping::within(unlimited, limits.delayed(bytes.ticks(3)));
            stored::<Body<T>, _>(bytes, Rejects, Ok(member))
        },
    });
}

/// A symmetric matrix; mostly above 0.
fn inertia<T: Real>(bytes: &mut Bytes<'_>) -> Matrix2<T> {
    let [one, two] = [(); 2].map(|()| bytes.positive::<T>());
    let both = if bytes.byte() % 4 == 0 {
        bytes.number()
    } else {
        (one * two).sqrt() * T::of(f64::from(bytes.byte() as i8) / 130.0)
    };
    Matrix2::new(one, both, both, two)
}
