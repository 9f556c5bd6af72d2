//! Promise of an own stabilizer.

use super::super::{LedgerKind, Manner, Pledge};

/// Promise of an own stabilizer: the most that [`hard`](crate::hard) holds it to.
///
/// Every one promises finite outputs, to reject what it cannot use and to recover after it, no negative damping, and no
/// debt untold: `L + α v² T + shortfall ≥ 0`. A bound of `hard` that is not promised may be passed; the case is then
/// reported as over, and is no failure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Promise {
    /// Nothing more: its efforts are its own.
    Finite,
    /// Efforts only get smaller, and keep their direction. No bound of `hard`.
    Cuts,
    /// Only damping is added, within the damping limit of the loop. No bound of `hard`: the stabilizer may wait,
    /// forget a debt, or credit what nobody else can see.
    Damps,
    /// That, and its observed energy is at most the port's work: stored credit may be forgotten, a debt may not. No
    /// bound of `hard`.
    Forgets,
    /// That, and every debt is served at once, up to the limit: the bounds of `hard`.
    ServesForgetting,
    /// The promise of POPC: its observed energy is the port's work, and every debt is served at once, up to the limit.
    Serves,
}

impl Promise {
    /// The same in the terms of the studies, for a stabilizer that credits nothing beyond the port's work.
    pub(super) fn pledge(self) -> Pledge {
        let damps = Pledge { account: LedgerKind::None, ..Pledge::POPC };
        match self {
            Self::Finite => Pledge::FREE,
            Self::Cuts => Pledge { manner: Manner::Cuts, ..damps },
            Self::Damps => damps,
            Self::Forgets | Self::ServesForgetting => Pledge::FORGETFUL,
            Self::Serves => Pledge::POPC,
        }
    }

    /// Whether the bounds of the hard cases are promised.
    pub(super) fn holds_bounds(self) -> bool {
        matches!(self, Self::Serves | Self::ServesForgetting)
    }

    /// Whether it takes energy out of a motion by a damper, or may.
    pub(super) fn adds_damping(self) -> bool {
        self != Self::Cuts
    }
}
