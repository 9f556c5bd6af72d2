//! Promises of a stabilizer beyond finite outputs.

use lyapunov::Scalar;

use crate::files::scene::{Candidate, Scene, Stabilizer};
use crate::simulate::family::{BasicName, Basis, Reference, StabilizerName};

/// Credit beyond the work of the port.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Credit {
    /// Nothing.
    None,
    /// `b v² T` where the position is greater than `beyond`: N·s/m, m.
    Damper { damping: f64, beyond: f64 },
    /// `b |Δx|² / T`, N·s/m.
    Moved { damping: f64 },
    /// Decrease of a reference's stored energy since the last tick, starting from a state in m and m/s.
    Reference { reference: Reference, start: [f64; 2] },
}

/// Kind of ledger that a stabilizer keeps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum LedgerKind {
    /// None, or one that cannot be recomputed outside of the stabilizer.
    None,
    /// Every work and credit counts.
    Whole,
    /// Every work counts, but the stabilizer may forget stored credit.
    Forgetful,
}

/// Way in which a stabilizer changes an effort.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Manner {
    /// It adds damping.
    Damps,
    /// It makes the effort smaller.
    Cuts,
    /// It follows the effort within a band.
    Follows,
}

/// Promises of one stabilizer.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Pledge {
    /// The credit.
    pub(super) credit: Credit,
    /// The observed energy at the start, J.
    pub(super) budget: f64,
    /// The kind of ledger.
    pub(super) account: LedgerKind,
    /// The way it may change an effort.
    pub(super) manner: Manner,
}

impl Pledge {
    /// Pledge of POPC: every joule is accounted for, and only damping is added.
    pub(super) const POPC: Self = Self {
        credit: Credit::None,
        budget: 0.0,
        account: LedgerKind::Whole,
        manner: Manner::Damps,
    };

    /// Pledge of POPC with the credit of a damper that always acts, N·s/m.
    pub(super) fn damper(damping: f64) -> Self {
        let credit = Credit::Damper { damping, beyond: f64::NEG_INFINITY };
        Self { credit, ..Self::POPC }
    }

    /// Pledge of `member` with the parameters of `basis`, in a scalar like `T`.
    pub(super) fn of<T: Scalar>(member: StabilizerName, basis: &Basis) -> Self {
        // The stabilizer credits the number as its scalar rounds it.
        let of = |number: f64| T::of(number).lane(0);
        match member {
            StabilizerName::Basic(
                BasicName::NoStabilizer | BasicName::Popc | BasicName::LolcSpring,
            )
            | StabilizerName::Threshold
            | StabilizerName::Spread
            | StabilizerName::RateLimited
            | StabilizerName::Rising => Self::POPC,
            StabilizerName::Basic(_) => Self::damper(of(basis.damping)),
            StabilizerName::Budgeted => Self { budget: of(basis.stored()), ..Self::POPC },
            StabilizerName::Bounded | StabilizerName::Windowed | StabilizerName::ContactReset => {
                Self { account: LedgerKind::Forgetful, ..Self::POPC }
            }
            StabilizerName::Reference => Self::on_reference(basis, of),
            StabilizerName::ForceBound => Self {
                credit: Credit::Moved { damping: of(basis.damping) },
                budget: of(basis.energy),
                manner: Manner::Cuts,
                ..Self::POPC
            },
            StabilizerName::Tank => Self {
                budget: of(basis.energy),
                account: LedgerKind::Forgetful,
                manner: Manner::Cuts,
                ..Self::POPC
            },
            StabilizerName::EnergyBounding => Self {
                credit: Credit::Moved { damping: of(basis.damping) },
                manner: Manner::Follows,
                ..Self::POPC
            },
            StabilizerName::ForceBounding => Self {
                credit: Credit::Moved { damping: of(basis.damping) },
                account: LedgerKind::Forgetful,
                manner: Manner::Cuts,
                ..Self::POPC
            },
            StabilizerName::MemoryBased => Self { manner: Manner::Cuts, ..Self::POPC },
            // The reference's damper only takes away.
            StabilizerName::ReferenceFollowing => {
                Self { account: LedgerKind::Forgetful, ..Self::on_reference(basis, of) }
            }
            // What it injects ahead of a debt is not yet on the account.
            StabilizerName::LeastNorm => Self { account: LedgerKind::Forgetful, ..Self::POPC },
        }
    }

    /// POPC's pledge with the reference of `basis` as credit.
    fn on_reference(basis: &Basis, of: impl Fn(f64) -> f64) -> Self {
        let start = basis.start.map(of);
        let credit = |reference| Credit::Reference { reference, start };
        let credit = basis.reference.clone().map_or(Credit::None, credit);
        Self { credit, ..Self::POPC }
    }

    /// Pledge of `member` on the loop of `scene`.
    pub(super) fn on<T: Scalar>(member: StabilizerName, scene: &Scene) -> Self {
        match member.basic_name().and_then(|basic_name| basic_name.on(scene)) {
            Some(named) => Self::named::<T>(named, scene),
            None => Self::of::<T>(member, &Basis::of(scene)),
        }
    }

    /// Pledge of the stabilizer `named` on the loop of `scene`.
    pub(super) fn named<T: Scalar>(named: Stabilizer, scene: &Scene) -> Self {
        let of = |number: f64| T::of(number).lane(0);
        let Stabilizer::Lolc(lolc) = named else { return Self::POPC };
        match (lolc.candidate, scene.environment.wall()) {
            (Candidate::Spring, _) => Self::POPC,
            (Candidate::DeviceDamping, _) => Self::damper(of(scene.device.damping.get())),
            (Candidate::MassSpringDamper, Some(wall)) => {
                let (damping, beyond) = (of(wall.damping.get()), of(wall.position.get()));
                Self { credit: Credit::Damper { damping, beyond }, ..Self::POPC }
            }
            (Candidate::MassSpringDamper, _) => Self { account: LedgerKind::None, ..Self::POPC },
        }
    }
}

/// Whether `member` makes the promises of POPC in the catalogue: it serves every debt at once, and credits nothing
/// that may not have been dissipated.
pub(super) fn promises(member: StabilizerName) -> bool {
    match member {
        StabilizerName::Basic(basic_name) => {
            matches!(
                basic_name,
                BasicName::Popc | BasicName::LolcSpring | BasicName::LolcDeviceDamping
            )
        }
        StabilizerName::Bounded
        | StabilizerName::Windowed
        | StabilizerName::ContactReset
        | StabilizerName::Reference
        | StabilizerName::ReferenceFollowing
        | StabilizerName::LeastNorm => true,
        StabilizerName::Budgeted
        | StabilizerName::Threshold
        | StabilizerName::Spread
        | StabilizerName::RateLimited
        | StabilizerName::Rising
        | StabilizerName::ForceBound
        | StabilizerName::Tank
        | StabilizerName::EnergyBounding
        | StabilizerName::ForceBounding
        | StabilizerName::MemoryBased => false,
    }
}
