//! Reference energy following.

use lyapunov::{ParameterError, Scalar};

use super::kind::{Install, OnALine, OnLoops, StabilizerKind};
use super::popc_reference::follow;
use super::table::table;
use super::{Basis, LedgerKind, Pledge};

table! {
    /// Reference energy following (Ryu, Preusche, Hannaford and Hirzinger 2005): the observed energy follows what the
    /// ideal environment stores and dissipates.
    ReferenceFollowing = "reference-following" {
        words {}
        numbers {
            damping_cap;
        }
    }
}

impl StabilizerKind for ReferenceFollowing {
    fn pledge(&self, on: &Basis) -> Pledge {
        // The reference's damper only takes away.
        Pledge { account: LedgerKind::Forgetful, ..Pledge::on_reference(on) }
    }

    fn promises(&self) -> bool {
        true
    }

    fn shape(&self, on: &Basis) -> u32 {
        on.reference.is_some().into()
    }
}

impl OnALine for ReferenceFollowing {
    fn make<T: Scalar, R: Install<T>>(
        on: OnLoops<'_, Self>,
        to: R,
    ) -> Result<R::Made, ParameterError> {
        let limit = on.limit(Self::damping_cap)?;
        let damper = |index: usize| on.each(|_, on| on.damper.unwrap_or_default()[index]);
        follow(on, limit, Some([0, 1].map(damper)), to)
    }
}
