//! The passivity observer/controller with a budget.

use lyapunov::{ParameterError, Popc, PortEnergy, Signal};

use super::kind::{Anywhere, Install, OnLoops, StabilizerKind};
use super::table::table;
use super::{Basis, Pledge, Search};

table! {
    /// The passivity observer/controller, credited at the start with what is stored.
    PopcBudgeted = "popc-budgeted" {
        words {}
        numbers {
            damping_cap;
            /// Credit at the start in J, 0 or more; default: what the environment stores there.
            budget: NonNegative, "J", "budget = 1e-3  # J",
            |_, on| on.stored(), |_, on| Search::up_to(on.energy);
        }
    }
}

impl StabilizerKind for PopcBudgeted {
    fn pledge(&self, on: &Basis) -> Pledge {
        Pledge { budget: self.budget(on), ..Pledge::POPC }
    }
}

impl Anywhere for PopcBudgeted {
    fn make<V: Signal, R: Install<V>>(
        on: OnLoops<'_, Self>,
        to: R,
    ) -> Result<R::Made, ParameterError> {
        let popc = Popc::<V::Scalar>::new(PortEnergy, on.limit(Self::damping_cap)?);
        Ok(to.behind(popc.budgeted(on.each(Self::budget))?))
    }
}
