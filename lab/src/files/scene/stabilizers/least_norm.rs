//! The least-norm filter.

use lyapunov::{ParameterError, PortEnergy, Signal, stabilizers::LeastNorm as Law};

use super::kind::{Anywhere, Install, OnLoops, StabilizerKind};
use super::table::table;
use super::{Basis, Pledge, Search};

table! {
    /// The least correction that keeps the next observed energy above a share of this one.
    LeastNorm = "least-norm" {
        words {}
        numbers {
            damping_cap;
            /// Share of the observed energy that a tick may spend, greater than 0 and at most 1; default 1.
            decay: Share, "", "decay = 1.0", |_, _| 1.0, |_, _| Search::ratios(0.01, 1.0);
        }
    }
}

impl StabilizerKind for LeastNorm {
    fn pledge(&self, _on: &Basis) -> Pledge {
        // What it injects ahead of a debt is not yet on the account.
        Pledge::FORGETFUL
    }

    fn promises(&self) -> bool {
        true
    }
}

impl Anywhere for LeastNorm {
    fn make<V: Signal, R: Install<V>>(
        on: OnLoops<'_, Self>,
        to: R,
    ) -> Result<R::Made, ParameterError> {
        let limit = on.limit(Self::damping_cap)?;
        Ok(to.behind(Law::new(PortEnergy, limit, on.each(Self::decay))?))
    }
}
