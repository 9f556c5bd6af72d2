//! The passivity observer/controller that enters each contact without credit.

use lyapunov::{ParameterError, Popc, PortEnergy, Scalar};
use lyapunov::{candidates::InContact, stabilizers::StabilizerExt};

use super::kind::{Install, OnALine, OnLoops, StabilizerKind};
use super::table::table;
use super::{Basis, Pledge};

table! {
    /// The passivity observer/controller, which enters each contact without stored credit.
    PopcContactReset = "popc-contact-reset" {
        words {}
        numbers {
            damping_cap;
            /// Place where contact begins in m; default: the surface of the environment, without one contact never
            /// begins.
            position: Finite, "m", "position = 0.0  # m",
            |_, on| on.surface.unwrap_or(f64::NEG_INFINITY), |_, _| None;
        }
    }
}

impl StabilizerKind for PopcContactReset {
    fn pledge(&self, _on: &Basis) -> Pledge {
        Pledge::FORGETFUL
    }

    fn promises(&self) -> bool {
        true
    }
}

impl OnALine for PopcContactReset {
    fn make<T: Scalar, R: Install<T>>(
        on: OnLoops<'_, Self>,
        to: R,
    ) -> Result<R::Made, ParameterError> {
        let popc = Popc::<T>::new(PortEnergy, on.limit(Self::damping_cap)?);
        let position = on.each(Self::position);
        Ok(to.behind(popc.reset_at(InContact { position })))
    }
}
