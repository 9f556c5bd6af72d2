//! Force bounding.

use lyapunov::{ParameterError, Signal, stabilizers::ForceBounding as Law};

use super::kind::{Anywhere, Install, OnLoops, StabilizerKind};
use super::table::table;
use super::{Basis, LedgerKind, Manner, Pledge};

/// Room for forces under way: few, and as many as a scene may delay.
const FEW: usize = 16;
const MOST: usize = 1024;

table! {
    /// Force bounding (Kim, Baek and Ryu 2015): forces that the device's damping has paid for in this contact.
    ForceBounding = "force-bounding" {
        words {}
        numbers {
            /// Damping that the device surely has in N.s/m, 0 or more; default: that of the device.
            damping: NonNegative, "N.s/m", "damping = 0.1  # N.s/m",
            |_, on| on.damping, |_, on| on.dampings();
        }
    }
}

impl StabilizerKind for ForceBounding {
    fn pledge(&self, on: &Basis) -> Pledge {
        let moved = Pledge::moved(self.damping(on));
        Pledge { account: LedgerKind::Forgetful, manner: Manner::Cuts, ..moved }
    }

    fn adds_damping(&self) -> bool {
        false
    }
}

impl Anywhere for ForceBounding {
    fn make<V: Signal, R: Install<V>>(
        on: OnLoops<'_, Self>,
        to: R,
    ) -> Result<R::Made, ParameterError> {
        let bounding = Law::of_damping(on.each(Self::damping))?;
        let delay = on.common().delay;
        Ok(match delay as usize {
            0 => to.behind(bounding),
            1..=FEW => to.behind(bounding.delayed::<FEW>(delay)?),
            _ => to.behind(bounding.delayed::<MOST>(delay)?),
        })
    }
}
