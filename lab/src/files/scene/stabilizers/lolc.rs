//! The Lyapunov observer/controller.

use super::kind::StabilizerKind;
use super::table::table;
use super::{Basis, Candidate, Credit, Ledger, LedgerKind, Pledge, Work};

table! {
    /// The Lyapunov observer/controller, which credits what its candidate knows to be burnt.
    Lolc = "lolc" {
        words {
            /// Booking of the port's work; default: held.
            work: Work, "work = \"held\"";
            /// Credit beyond the port's work; default: the paper's mass-spring-damper.
            candidate: Candidate, "candidate = \"device-damping\"";
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

impl StabilizerKind for Lolc {
    fn pledge(&self, on: &Basis) -> Pledge {
        let pledge = match (self.candidate, on.damper) {
            (Candidate::Spring, _) => Pledge::POPC,
            (Candidate::DeviceDamping, _) => Pledge::damper(on.damping),
            (Candidate::MassSpringDamper, Some([damping, beyond])) => {
                Pledge { credit: Credit::Damper { damping, beyond }, ..Pledge::POPC }
            }
            (Candidate::MassSpringDamper, None) => {
                Pledge { account: LedgerKind::None, ..Pledge::POPC }
            }
        };
        Pledge { work: self.work, ..pledge }
    }
}
