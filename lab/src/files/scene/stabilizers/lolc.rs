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
            damping_cap;
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
