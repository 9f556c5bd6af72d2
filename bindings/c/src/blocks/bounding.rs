//! Members of the family that reduce efforts whose energy is not covered.

use lyapunov::stabilizers::{
    EnergyBounding, EnergyTank, ForceBound, ForceBounding, LeastNorm, MemoryBased, PathMemory,
    SlopeBound, Tank, TankLimits,
};
use lyapunov::{Dissipation, ParameterError, PortEnergy, Requirement};

use crate::export::blocks;
use crate::limits::limit;
use crate::number::Number;

/// Cells of the memories of a way.
const CELLS: usize = 64;

/// The same limits. A floor above the ceiling is told by itself: on retuning it stands in for the start.
fn ordered<T: Number>(limits: TankLimits<T>) -> Result<TankLimits<T>, ParameterError> {
    if limits.floor.above(limits.ceiling) {
        Requirement::AtMost(limits.ceiling.lane(0)).check("floor", limits.floor)?;
    }
    Ok(limits)
}

blocks! {
    /// Force bounding that keeps what free motion dissipated (ForceBound).
    force_bound on every = {
        "force_bound";
        ForceBound<T>, whole 2 + 0;
        {
            /// Damping that the device surely has, N.s/m, at least 0.
            damping: T,
        };
        |given| ForceBound::new(given.damping);
        [life stabilizer account]
    }
    /// Force bounding that starts anew at each contact (ForceBounding).
    force_bounding on every = {
        "force_bounding";
        ForceBounding<T>, whole 2 + 0;
        {
            /// Damping that the device surely has, N.s/m, at least 0.
            damping: T,
        };
        |given| ForceBounding::of_damping(given.damping);
        [life stabilizer account]
    }
    /// Energy tank (Tank): efforts that an empty tank cannot pay are reduced.
    tank on every = {
        "tank";
        Tank<T, (PortEnergy, Dissipation<T>)>, whole 4 + 0;
        {
            /// Energy at the start, J, from `floor` to `ceiling`. Only init reads it: `retune` does not.
            start: T => floor,
            /// The least energy, J, at least 0 and at most `ceiling`.
            floor: T,
            /// The most energy, J, at least `floor`; infinity: no limit.
            ceiling: T,
            /// The most power that is drawn, W; infinity: no limit.
            power: T,
            /// Damping that the device surely has, N.s/m, which fills the tank.
            device_damping: T,
        };
        |given| {
            let (start, floor) = (given.start, given.floor);
            let store = TankLimits { start, floor, ceiling: given.ceiling, power: given.power };
            Tank::new((PortEnergy, Dissipation::of(given.device_damping)?), ordered(store)?)
        };
        [life stabilizer account]
    }
    /// Energy tank with a port (EnergyTank): filled by what your controller dissipates, it lets pass as much of a wished input as it
    /// can pay for at the flow that you tell. It is asked, and has no samples.
    energy_tank on every = {
        "energy_tank";
        EnergyTank<T>, whole 5 + 0;
        {
            /// Energy at the start, J, from `floor` to `ceiling`. Only init reads it: `retune` does not.
            start: T => floor,
            /// The least energy, J, at least 0 and at most `ceiling`.
            floor: T,
            /// The most energy, J, at least `floor`; infinity: no limit.
            ceiling: T,
            /// The most power that is drawn, W; infinity: no limit.
            power: T,
        };
        |given| {
            let (start, floor) = (given.start, given.floor);
            let store = TankLimits { start, floor, ceiling: given.ceiling, power: given.power };
            EnergyTank::new(ordered(store)?)
        };
        [life drawn]
    }
    /// Energy-bounding algorithm (EnergyBounding), for a force that may act late.
    energy_bounding on every = {
        "energy_bounding";
        EnergyBounding<V>, whole 6 + 1;
        {
            /// Damping that the device surely has, N.s/m, above 0.
            damping: T,
            /// The period, s, above 0.
            period: T,
            /// The delay of the force in ticks.
            late: u32,
        };
        |given| EnergyBounding::of_damping(given.damping, given.period)?.delayed(given.late);
        [life stabilizer account]
    }
    /// Least-norm filter (LeastNorm): the least damping that keeps the observed energy above a decaying barrier.
    least_norm on every = {
        "least_norm";
        LeastNorm<T, (PortEnergy, Dissipation<T>)>, whole 4 + 0;
        {
            /// Largest damping, N.s/m.
            damping_limit: T,
            /// The share of the credit that a tick may spend, above 0 and at most 1.
            decay: T,
            /// Damping that the device surely has, N.s/m.
            device_damping: T,
            /// Energy stored in the loop at the start, which may come back, J; usually 0. Only init reads it: `retune` does
            /// not, and later there is `grant`.
            budget: T => 0.0,
        };
        |given| {
            let candidate = (PortEnergy, Dissipation::of(given.device_damping)?);
            LeastNorm::new(candidate, limit(given.damping_limit)?, given.decay)?.budgeted(given.budget)
        };
        [life stabilizer account]
    }
    /// Slope bound (SlopeBound): efforts change no faster with the displacement than a slope.
    slope_bound on every = {
        "slope_bound";
        SlopeBound<V>, words;
        {
            /// The slope, N/m, above 0.
            slope: T,
            /// The rate at which withheld force is let through, N/s; 0: none of it.
            creep: T,
        };
        |given| SlopeBound::new(given.slope)?.creeping(given.creep);
        [life stabilizer account]
    }
    /// Memory-based passivation (MemoryBased): forces on the way out no larger than those kept from the way in, in 64 cells.
    memory_based on line = {
        "memory_based";
        MemoryBased<T, CELLS>, words;
        {
            /// Position of the wall's surface, m.
            surface: T,
            /// The depth that the cells span, m, above 0.
            depth: T,
            /// The delay of the force in ticks.
            late: u32,
        };
        |given| Ok(MemoryBased::beyond(given.surface, given.depth)?.delayed(given.late));
        [life stabilizer account]
    }
    /// Path memory (PathMemory): energies on the way out no larger than those kept from the way in, in 64 cells.
    path_memory on line = {
        "path_memory";
        PathMemory<T, CELLS>, whole 67 + 0;
        {
            /// Position of the wall's surface, m.
            surface: T,
            /// The depth that the cells span, m, above 0.
            depth: T,
        };
        |given| PathMemory::beyond(given.surface, given.depth);
        [life stabilizer]
    }
}
