//! The passivity observer/controller with a slow correction.

use lyapunov::stabilizers::StabilizerExt;
use lyapunov::{ParameterError, Popc, PortEnergy, Signal};

use super::kind::{Anywhere, Install, OnLoops, StabilizerKind};
use super::table::table;
use super::{Basis, Pledge, Search};

table! {
    /// The passivity observer/controller, whose correction grows slowly.
    PopcRateLimited = "popc-rate-limited" {
        words {}
        numbers {
            damping_cap;
            /// Fastest growth of the correction in N/s, 0 or more, inf for no limit; default: to the largest
            /// correction, at the speed of the energy that the motion starts with, within 2 ticks or a tick of the
            /// environment.
            rate: Cap, "N/s", "rate = 2000.0  # N/s",
            |own, on| on.rate(own.damping_cap(on)),
            |at, _| Search::ratios(0.01 * at, 10.0 * at);
        }
    }
}

impl StabilizerKind for PopcRateLimited {
    fn pledge(&self, _on: &Basis) -> Pledge {
        Pledge::POPC
    }
}

impl Anywhere for PopcRateLimited {
    fn make<V: Signal, R: Install<V>>(
        on: OnLoops<'_, Self>,
        to: R,
    ) -> Result<R::Made, ParameterError> {
        let popc = Popc::<V::Scalar>::new(PortEnergy, on.limit(Self::damping_cap)?);
        Ok(to.behind(popc.rate_limited::<V>(on.each(Self::rate))?))
    }
}
