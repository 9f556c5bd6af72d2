//! The passivity observer/controller with a bounded credit.

use lyapunov::stabilizers::StabilizerExt;
use lyapunov::{ParameterError, Popc, PortEnergy, Signal};

use super::kind::{Anywhere, Install, OnLoops, StabilizerKind};
use super::table::table;
use super::{Basis, Pledge};

table! {
    /// The passivity observer/controller, whose stored credit is bounded.
    PopcBounded = "popc-bounded" {
        words {}
        numbers {
            damping_cap;
            /// Most stored credit in J, 0 or more, inf for no bound; default: the energy that the motion starts with.
            credit: Cap, "J", "credit = 1e-3  # J",
            |_, on| on.energy, |_, on| on.energies();
        }
    }
}

impl StabilizerKind for PopcBounded {
    fn pledge(&self, _on: &Basis) -> Pledge {
        Pledge::FORGETFUL
    }

    fn promises(&self) -> bool {
        true
    }
}

impl Anywhere for PopcBounded {
    fn make<V: Signal, R: Install<V>>(
        on: OnLoops<'_, Self>,
        to: R,
    ) -> Result<R::Made, ParameterError> {
        let popc = Popc::<V::Scalar>::new(PortEnergy, on.limit(Self::damping_cap)?);
        Ok(to.behind(popc.bounded(on.each(Self::credit))?))
    }
}
