//! The passivity observer/controller with a soft start.

use lyapunov::stabilizers::StabilizerExt;
use lyapunov::{ParameterError, Popc, PortEnergy, Signal};

use super::kind::{Anywhere, Install, OnLoops, StabilizerKind};
use super::table::table;
use super::{Basis, Pledge};

table! {
    /// The passivity observer/controller, whose correction rises when it engages.
    PopcRising = "popc-rising" {
        words {}
        numbers {
            damping_cap;
            /// Ticks over which a correction rises, a whole number from 1 to 1000000; default: 2, or those of a tick of
            /// the environment if they are more.
            ticks: Ticks, "servo ticks", "ticks = 4  # servo ticks",
            |_, on| on.ticks().into(), |_, on| on.spans();
        }
    }
}

impl StabilizerKind for PopcRising {
    fn pledge(&self, _on: &Basis) -> Pledge {
        Pledge::POPC
    }

    fn shape(&self, on: &Basis) -> u32 {
        self.ticks(on) as u32
    }
}

impl Anywhere for PopcRising {
    fn make<V: Signal, R: Install<V>>(
        on: OnLoops<'_, Self>,
        to: R,
    ) -> Result<R::Made, ParameterError> {
        let popc = Popc::<V::Scalar>::new(PortEnergy, on.limit(Self::damping_cap)?);
        Ok(to.behind(popc.rising_over::<V::Scalar>(on.shape())?))
    }
}
