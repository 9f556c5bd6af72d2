//! Promises of a stabilizer beyond finite outputs.

use super::{Basis, Reference, Work};

/// Credit beyond the work of the port.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Credit {
    /// Nothing.
    None,
    /// `b v² T` where the position is greater than `beyond`: N·s/m, m.
    Damper { damping: f64, beyond: f64 },
    /// `b |Δx|² / T`, N·s/m, where the sample spans a time; the period is that of the sample, and none below `least`, s.
    Moved { damping: f64, least: f64 },
    /// Decrease of a reference's stored energy since the last tick, from the first one on.
    Reference(Reference),
}

/// Kind of ledger that a stabilizer keeps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LedgerKind {
    /// None, or one that cannot be recomputed outside of the stabilizer.
    None,
    /// Every work and credit counts.
    Whole,
    /// Every work counts, but the stabilizer may forget stored credit.
    Forgetful,
}

/// Way in which a stabilizer changes an effort.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Manner {
    /// It adds damping.
    Damps,
    /// It adds damping in some directions: on an axis a correction may push along, over all of them it takes energy.
    Directs,
    /// It makes the effort smaller.
    Cuts,
    /// It follows the effort within a band.
    Follows,
    /// It is asked no effort: it answers by itself, as a port around the environment does.
    Answers,
}

/// Promises of one stabilizer.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Pledge {
    /// The credit.
    pub(crate) credit: Credit,
    /// The observed energy at the start, J.
    pub(crate) budget: f64,
    /// The work that is booked.
    pub(crate) work: Work,
    /// The kind of ledger.
    pub(crate) account: LedgerKind,
    /// The way it may change an effort.
    pub(crate) manner: Manner,
}

impl Pledge {
    /// Pledge of POPC: every joule is accounted for, and only damping is added.
    pub(crate) const POPC: Self = Self {
        credit: Credit::None,
        budget: 0.0,
        work: Work::Held,
        account: LedgerKind::Whole,
        manner: Manner::Damps,
    };

    /// Pledge of POPC that may forget stored credit.
    pub(crate) const FORGETFUL: Self = Self { account: LedgerKind::Forgetful, ..Self::POPC };

    /// Pledge of a stabilizer without a ledger that can be recomputed, and with efforts of its own.
    pub(crate) const FREE: Self =
        Self { account: LedgerKind::None, manner: Manner::Follows, ..Self::POPC };

    /// Pledge of a port around the environment, which answers by itself.
    pub(crate) const ANSWERING: Self = Self { manner: Manner::Answers, ..Self::FREE };

    /// Pledge of POPC with the credit of a damper that always acts, N·s/m.
    pub(crate) fn damper(damping: f64) -> Self {
        let credit = Credit::Damper { damping, beyond: f64::NEG_INFINITY };
        Self { credit, ..Self::POPC }
    }

    /// Pledge of a whole account that credits what a damper dissipates of every displacement, N·s/m.
    pub(super) fn moved(damping: f64) -> Self {
        Self { credit: Credit::Moved { damping, least: 0.0 }, ..Self::POPC }
    }

    /// POPC's pledge with the reference of a loop as credit.
    pub(super) fn on_reference(on: &Basis) -> Self {
        let credit = on.reference.clone().map_or(Credit::None, Credit::Reference);
        Self { credit, ..Self::POPC }
    }

    /// The same with each number rounded by `round`, as the scalar of the stabilizer rounds it.
    pub(crate) fn rounded(self, round: impl Fn(f64) -> f64) -> Self {
        let credit = match self.credit {
            Credit::None => Credit::None,
            Credit::Damper { damping, beyond } => {
                Credit::Damper { damping: round(damping), beyond: round(beyond) }
            }
            Credit::Moved { damping, least } => {
                Credit::Moved { damping: round(damping), least: round(least) }
            }
            Credit::Reference(reference) => Credit::Reference(reference),
        };
        Self { credit, budget: round(self.budget), ..self }
    }
}
