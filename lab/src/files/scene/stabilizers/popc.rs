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
            damping_cap;
        }
    }
}

impl StabilizerKind for Popc {
    fn pledge(&self, _on: &Basis) -> Pledge {
        Pledge { work: self.work, ..Pledge::POPC }
    }
}
