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
            /// Limit of the injected damping in units of m / T, 0 or more, inf for no limit; default 0.5, where a force
            /// acts d ticks late 0.5 tan(pi / (4 (d + 1))). A limit of 0 only observes.
            damping_cap: Cap, "m / T", "damping_cap = 0.5  # m / T",
            |_, on| on.limit.cap, |_, on| on.caps();
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
