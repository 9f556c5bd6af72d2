//! Members that bound a force, and ports that ask the environment elsewhere, on one axis.

use lyapunov_core::{ParameterError, PortEnergy};
use lyapunov_stabilizers::{
    BoundedValve, CoupledPort, EnergyBounding, EnergyTank, ForceBound, ForceBounding, InputToState,
    MemoryBased, OpenValve, PathMemory, SlopeBound, Tank, VirtualCoupling,
};

use super::{Number, Visit, period, store};
use crate::port::{Answering, Constrained, Draws, Spring};

type Shown = Result<(), ParameterError>;

/// Cells of the memories: few, so that they fit beside a stack in 16 kB.
const CELLS: usize = 16;

/// Bounds of the force.
#[inline(never)]
pub(super) fn forces<T: Number>(visit: &mut impl Visit<T>) -> Shown {
    let of = T::of;
    visit.member::<T, ForceBound<T>>("force-bound", ForceBound::new(of(0.1))?);
    let bounding: ForceBounding<T> = ForceBounding::of_damping(of(0.1))?;
    visit.member::<T, _>("force-bounding", bounding);
    visit.member::<T, _>("force-bounding-late", bounding.delayed::<4>(3)?);
    let bounding: EnergyBounding<T> = EnergyBounding::new(of(500.0), of(250.0))?;
    visit.member::<T, _>("energy-bounding", bounding);
    let tight: EnergyBounding<T, _> = EnergyBounding::tight(of(0.5), period())?;
    visit.member::<T, _>("energy-bounding-tight", tight);
    visit.member::<T, SlopeBound<T>>("slope-bound", SlopeBound::new(of(1e3))?.creeping(of(5.0))?);
    Ok(())
}

/// Memories of the way.
#[inline(never)]
pub(super) fn memories<T: Number>(visit: &mut impl Visit<T>) -> Shown {
    let (surface, depth) = (T::of(-0.01), T::of(0.1));
    let memory: MemoryBased<T, CELLS> = MemoryBased::beyond(surface, depth)?;
    visit.member::<T, _>("memory-based", memory);
    let memory: PathMemory<T, CELLS> = PathMemory::beyond(surface, depth)?;
    visit.member::<T, _>("path-memory", memory);
    Ok(())
}

/// Tanks, and a constraint.
#[inline(never)]
pub(super) fn stores<T: Number>(visit: &mut impl Visit<T>) -> Shown {
    visit.member::<T, Tank<T, _>>("tank", Tank::new(PortEnergy, store())?);
    let tank: EnergyTank<T, BoundedValve> = EnergyTank::new(store())?;
    visit.member::<T, _>("energy-tank", Draws(tank));
    let open: EnergyTank<T, OpenValve> = tank.opening();
    visit.member::<T, _>("energy-tank-open", Draws(open));
    visit.member::<T, _>("constraint", Constrained);
    Ok(())
}

/// Ports around a spring.
#[inline(never)]
pub(super) fn ports<T: Number>(visit: &mut impl Visit<T>) -> Shown {
    let of = T::of;
    let spring = Spring(of(1e4));
    let iss: InputToState<_, T> = InputToState::new(spring, of(1.7e4), of(5e-3))?;
    visit.member::<T, _>("iss", Answering(iss));
    let iss: InputToState<_, T> = InputToState::adaptive(spring, of(1.7), of(5e-3))?;
    visit.member::<T, _>("iss-adaptive", Answering(iss));
    let coupling = VirtualCoupling { stiffness: of(1e3), damping: of(0.1), drag: of(5.0) };
    let coupled: CoupledPort<_, T> = CoupledPort::new(spring, coupling)?;
    visit.member::<T, _>("virtual-coupling", Answering(coupled));
    Ok(())
}
