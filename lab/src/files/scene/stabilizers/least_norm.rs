//! The least-norm filter.

use lyapunov::{ParameterError, PortEnergy, Scalar, Signal, stabilizers::LeastNorm as Law};

use super::kind::{Anywhere, Install, StabilizerKind};
use super::table::table;
use super::{Basis, Pledge, Search};

table! {
    /// The least correction that keeps the next observed energy above a share of this one.
    LeastNorm = "least-norm" {
        words {}
        numbers {
            /// Limit of the injected damping in units of m / T, 0 or more, inf for no limit; default 0.5, where a force
            /// acts d ticks late 0.5 tan(pi / (4 (d + 1))). A limit of 0 only observes.
            damping_cap: Cap, "m / T", "damping_cap = 0.5  # m / T",
            |_, on| on.limit.cap, |_, on| on.caps();
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
    fn make<V: Signal, R: Install<V>>(&self, on: &Basis, to: R) -> Result<R::Made, ParameterError> {
        let limit = on.limit(self.damping_cap(on))?;
        Ok(to.behind(Law::new(PortEnergy, limit, V::Scalar::of(self.decay(on)))?))
    }
}
