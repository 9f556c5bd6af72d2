//! Force bounding with a budget in place of the reset.

use lyapunov::{ParameterError, Signal, stabilizers::ForceBound as Law};

use super::kind::{Anywhere, Install, OnLoops, StabilizerKind};
use super::table::table;
use super::{Basis, Manner, Pledge};

table! {
    /// Bound of the force by what the device's damping has dissipated, with a budget.
    ForceBound = "force-bound" {
        words {}
        numbers {
            /// Damping that the device surely has in N.s/m, 0 or more; default: that of the device.
            damping: NonNegative, "N.s/m", "damping = 0.1  # N.s/m",
            |_, on| on.damping, |_, on| on.dampings();
            /// Energy on its account at the start in J, 0 or more; default: the energy that the motion starts with.
            budget: NonNegative, "J", "budget = 1e-3  # J",
            |_, on| on.energy, |_, on| on.energies();
        }
    }
}

impl StabilizerKind for ForceBound {
    fn pledge(&self, on: &Basis) -> Pledge {
        let moved = Pledge::moved(self.damping(on));
        Pledge { budget: self.budget(on), manner: Manner::Cuts, ..moved }
    }

    fn adds_damping(&self) -> bool {
        false
    }
}

impl Anywhere for ForceBound {
    fn make<V: Signal, R: Install<V>>(
        on: OnLoops<'_, Self>,
        to: R,
    ) -> Result<R::Made, ParameterError> {
        let bound = Law::new(on.each(Self::damping))?;
        Ok(to.behind(bound.budgeted(on.each(Self::budget))?))
    }
}
