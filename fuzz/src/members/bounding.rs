//! Members that bound a force, and ports that ask the environment elsewhere, on one axis.

use lyapunov_core::PortEnergy;
use lyapunov_embedded::{Answering, Constrained, Draws, Spring};
use lyapunov_stabilizers::{
    BoundedValve, CoupledPort, EnergyBounding, EnergyTank, ForceBound, ForceBounding, InputToState,
    MemoryBased, PathMemory, SlopeBound, Tank, VirtualCoupling,
};

use super::{Member, store};
use crate::Real;
use crate::check::Manner::{Answers, Asks, Reduces, Rejects};
use crate::drive::{copied, stored};

/// Cells of the memories.
const CELLS: usize = 16;

/// Adds all of them.
pub(super) fn list<T: Real>(members: &mut Vec<Member>) {
    forces::<T>(members);
    energies::<T>(members);
    memories::<T>(members);
    stores::<T>(members);
    ports::<T>(members);
}

fn forces<T: Real>(members: &mut Vec<Member>) {
    members.push(Member {
        name: "force-bound",
        run: |bytes| {
            let damping = bytes.parameter::<T>();
            stored::<T, _>(bytes, Reduces, ForceBound::new(damping))
        },
    });
    members.push(Member {
        name: "force-bounding",
        run: |bytes| {
            let damping = bytes.parameter::<T>();
            let member: Result<ForceBounding<T>, _> = ForceBounding::of_damping(damping);
            stored::<T, _>(bytes, Reduces, member)
        },
    });
    members.push(Member {
        name: "force-bounding-late",
        run: |bytes| {
            let bounding: ForceBounding<T> = ForceBounding::of_damping(bytes.parameter())?;
            let ticks = bytes.ticks(6);
            stored::<T, _>(bytes, Reduces, bounding.delayed::<4>(ticks))
        },
    });
    members.push(Member {
        name: "slope-bound",
        run: |bytes| {
            let (slope, creep) = (bytes.positive::<T>(), bytes.parameter::<T>());
            let member = SlopeBound::new(slope).and_then(|it: SlopeBound<T>| it.creeping(creep));
            stored::<T, _>(bytes, Reduces, member)
        },
    });
}

fn energies<T: Real>(members: &mut Vec<Member>) {
    members.push(Member {
        name: "energy-bounding",
        run: |bytes| {
            let (rise, share) = (bytes.positive::<T>(), bytes.byte());
            let release = rise * T::of(f64::from(share) / 255.0);
            let member: Result<EnergyBounding<T>, _> = match share % 4 {
                0 => EnergyBounding::of_damping(rise, bytes.positive()),
                1 => EnergyBounding::of_damping(rise, bytes.positive())
                    .and_then(|it| it.delayed(bytes.ticks(20))),
                2 => EnergyBounding::new(rise, bytes.parameter()),
                _ => EnergyBounding::new(rise, release),
            };
            stored::<T, _>(bytes, Rejects, member)
        },
    });
    members.push(Member {
        name: "energy-bounding-tight",
        run: |bytes| {
            let (damping, period) = (bytes.positive::<T>(), bytes.positive());
            stored::<T, _>(bytes, Rejects, EnergyBounding::tight(damping, period))
        },
    });
}

fn memories<T: Real>(members: &mut Vec<Member>) {
    members.push(Member {
        name: "memory-based",
        run: |bytes| {
            let (surface, depth) = (bytes.number::<T>(), bytes.positive::<T>());
            let late = bytes.ticks(6);
            let member = MemoryBased::<T, CELLS>::beyond(surface, depth);
            stored::<T, _>(bytes, Rejects, member.map(|it| it.delayed(late)))
        },
    });
    members.push(Member {
        name: "path-memory",
        run: |bytes| {
            let (surface, depth) = (bytes.number::<T>(), bytes.positive::<T>());
            stored::<T, _>(bytes, Rejects, PathMemory::<T, CELLS>::beyond(surface, depth))
        },
    });
}

fn stores<T: Real>(members: &mut Vec<Member>) {
    members.push(Member {
        name: "tank",
        run: |bytes| {
            let store = store::<T>(bytes);
            stored::<T, _>(bytes, Reduces, Tank::new(PortEnergy, store))
        },
    });
    members.push(Member {
        name: "energy-tank",
        run: |bytes| {
            let tank = EnergyTank::<T, BoundedValve>::new(store(bytes))?;
            copied::<T, _>(bytes, Answers, Ok(Draws(tank)))
        },
    });
    members.push(Member {
        name: "energy-tank-open",
        run: |bytes| {
            let tank = EnergyTank::<T, BoundedValve>::new(store(bytes))?;
            copied::<T, _>(bytes, Answers, Ok(Draws(tank.opening())))
        },
    });
    members.push(Member {
        name: "constraint",
        run: |bytes| copied::<T, _>(bytes, Answers, Ok(Constrained)),
    });
}

fn ports<T: Real>(members: &mut Vec<Member>) {
    members.push(Member {
        name: "iss",
        run: |bytes| {
            let stiffness = bytes.positive::<T>();
            // The environment is no steeper than the slope says.
            let slope = stiffness * T::of(1.0 + f64::from(bytes.byte()) / 16.0);
            let port: InputToState<_, T> =
                InputToState::new(Spring(stiffness), slope, bytes.parameter())?;
            copied::<T, _>(bytes, Asks, Ok(Answering(port)))
        },
    });
    members.push(Member {
        name: "iss-adaptive",
        run: |bytes| {
            let (spring, share) = (Spring(bytes.positive::<T>()), bytes.positive());
            let port: InputToState<_, T> =
                InputToState::adaptive(spring, share, bytes.parameter())?;
            copied::<T, _>(bytes, Asks, Ok(Answering(port)))
        },
    });
    members.push(Member {
        name: "virtual-coupling",
        run: |bytes| {
            let spring = Spring(bytes.positive::<T>());
            let [stiffness, damping, drag] = [(); 3].map(|()| bytes.positive());
            let coupling = VirtualCoupling { stiffness, damping, drag };
            let port: CoupledPort<_, T> = CoupledPort::new(spring, coupling)?;
            copied::<T, _>(bytes, Asks, Ok(Answering(port)))
        },
    });
}
