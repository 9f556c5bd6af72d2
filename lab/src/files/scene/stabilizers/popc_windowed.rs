//! The passivity observer/controller with a credit that expires.

use lyapunov::{ParameterError, Popc, PortEnergy, Signal};
use lyapunov::{accumulators::Plain, stabilizers::WindowedCredit};

use super::basis::SLOTS;
use super::kind::{Anywhere, Install, OnLoops, StabilizerKind};
use super::table::table;
use super::{Basis, Pledge, Search};

table! {
    /// The passivity observer/controller, whose stored credit expires.
    PopcWindowed = "popc-windowed" {
        words {}
        numbers {
            damping_cap;
            /// Time after which credit expires in s, greater than 0, in 8 slots; default: one swing of the hand.
            window: Positive, "s", "window = 0.5  # s",
            |_, on| on.swing, |at, on| Search::ratios(SLOTS as f64 * on.limit.period, 10.0 * at);
        }
    }
}

impl StabilizerKind for PopcWindowed {
    fn pledge(&self, _on: &Basis) -> Pledge {
        Pledge::FORGETFUL
    }

    fn promises(&self) -> bool {
        true
    }

    /// The ticks of a slot.
    fn shape(&self, on: &Basis) -> u32 {
        // The conversion saturates: no run leaves a longer slot either.
        (self.window(on) / (SLOTS as f64 * on.limit.period)).ceil().max(1.0) as u32
    }
}

impl Anywhere for PopcWindowed {
    fn make<V: Signal, R: Install<V>>(
        on: OnLoops<'_, Self>,
        to: R,
    ) -> Result<R::Made, ParameterError> {
        let popc = Popc::<V::Scalar>::new(PortEnergy, on.limit(Self::damping_cap)?);
        let sum = WindowedCredit::<V::Scalar, Plain<V::Scalar>, SLOTS>::of_ticks(on.shape())?;
        Ok(to.behind(popc.summed_by(sum)))
    }
}
