//! Energy tank.

use lyapunov::{ParameterError, PortEnergy, Signal, stabilizers};

use super::kind::{Anywhere, Install, OnLoops, StabilizerKind};
use super::table::table;
use super::{Basis, Manner, Pledge, Search};
use crate::files::scene::check::Conflict;

table! {
    /// Energy tank: the port gives what is in it, and fills it by what it takes.
    Tank = "tank" {
        words {}
        numbers {
            /// Energy in it at the start in J, 0 or more; default: the energy that the motion starts with.
            start: NonNegative, "J", "start = 1e-3  # J",
            |_, on| on.energy, |at, _| Search::ratios(1e-3 * at, 2.0 * at);
            /// Energy that is never handed out in J, 0 or more, at most that at the start; default 0.
            floor: NonNegative, "J", "floor = 0.0  # J", |_, _| 0.0, |_, _| None;
            /// Most energy that it holds in J, at least that at the start, inf for no limit; default: twice that at the
            /// start.
            ceiling: Cap, "J", "ceiling = 2e-3  # J",
            |own, on| 2.0 * own.start(on), |_, on| Search::ratios(2.0 * on.energy, 20.0 * on.energy);
            /// Most power that it hands out in W, 0 or more, inf for no limit; default inf.
            power: Cap, "W", "power = inf  # W", |_, _| f64::INFINITY,
            |_, on| Search::ratios(0.1 * on.energy / on.swing, on.energy / on.limit.period);
        }
    }
}

impl StabilizerKind for Tank {
    fn pledge(&self, on: &Basis) -> Pledge {
        Pledge {
            budget: self.start(on) - self.floor(on),
            manner: Manner::Cuts,
            ..Pledge::FORGETFUL
        }
    }

    fn adds_damping(&self) -> bool {
        false
    }

    fn check(&self, on: &Basis) -> Result<(), Conflict> {
        let (start, floor, ceiling) = (self.start(on), self.floor(on), self.ceiling(on));
        if floor > start {
            return Err(Conflict::new(
                "stabilizer.tank.floor",
                format!("`stabilizer.tank.floor` = {floor:?} J is more than `start` = {start:?} J"),
                "a tank hands out what is above its floor: give at most what it starts with",
            ));
        }
        if ceiling < start {
            return Err(Conflict::new(
                "stabilizer.tank.ceiling",
                format!(
                    "`stabilizer.tank.ceiling` = {ceiling:?} J is less than `start` = {start:?} J"
                ),
                "a tank starts no fuller than it can be: give at least what it starts with",
            ));
        }
        Ok(())
    }
}

impl Anywhere for Tank {
    fn make<V: Signal, R: Install<V>>(
        on: OnLoops<'_, Self>,
        to: R,
    ) -> Result<R::Made, ParameterError> {
        let store = stabilizers::TankLimits {
            start: on.each(Self::start),
            floor: on.each(Self::floor),
            ceiling: on.each(Self::ceiling),
            power: on.each(Self::power),
        };
        Ok(to.behind(stabilizers::Tank::new(PortEnergy, store)?))
    }
}
