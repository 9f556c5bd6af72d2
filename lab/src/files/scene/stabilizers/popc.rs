//! The passivity observer/controller.

use super::kind::StabilizerKind;
use super::table::table;
use super::{Basis, Ledger, Pledge, Work};

table! {
    /// The passivity observer/controller, whose candidate is the port's own energy.
    Popc = "popc" {
        words {
            /// Booking of the port's work; default: held.
            work: Work, "work = \"held\"";
            /// Accumulator of the energies; default: plain.
            ledger: Ledger, "ledger = \"wide\"";
        }
        numbers {
            /// Limit of the injected damping in units of m / T, 0 or more, inf for no limit; default 0.5, where a force
            /// acts d ticks late 0.5 tan(pi / (4 (d + 1))). A limit of 0 only observes.
            damping_cap: Cap, "m / T", "damping_cap = 0.5  # m / T",
            |_, on| on.limit.cap, |_, on| on.caps();
        }
    }
}

impl StabilizerKind for Popc {
    fn pledge(&self, _on: &Basis) -> Pledge {
        Pledge { work: self.work, ..Pledge::POPC }
    }
}
