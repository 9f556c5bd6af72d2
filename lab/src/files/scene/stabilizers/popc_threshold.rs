//! The passivity observer/controller above a velocity.

use lyapunov::stabilizers::StabilizerExt;
use lyapunov::{ParameterError, Popc, PortEnergy, Signal};

use super::kind::{Anywhere, Install, OnLoops, StabilizerKind};
use super::table::table;
use super::{Basis, Pledge, Search};

table! {
    /// The passivity observer/controller, which corrects from a velocity on.
    PopcThreshold = "popc-threshold" {
        words {}
        numbers {
            damping_cap;
            /// Least velocity that is corrected in m/s, 0 or more; default: one and a half counts of the encoder a tick,
            /// without an encoder a hundredth of the speed of the energy that the motion starts with. Slower swings are
            /// left alone.
            velocity: NonNegative, "m/s", "velocity = 0.01  # m/s",
            |_, on| on.threshold(), |_, on| Search::ratios(1e-3 * on.speed, on.speed);
        }
    }
}

impl StabilizerKind for PopcThreshold {
    fn pledge(&self, _on: &Basis) -> Pledge {
        Pledge::POPC
    }
}

impl Anywhere for PopcThreshold {
    fn make<V: Signal, R: Install<V>>(
        on: OnLoops<'_, Self>,
        to: R,
    ) -> Result<R::Made, ParameterError> {
        let popc = Popc::<V::Scalar>::new(PortEnergy, on.limit(Self::damping_cap)?);
        Ok(to.behind(popc.above_velocity(on.each(Self::velocity))?))
    }
}
