//! A bound of the slope.

use lyapunov::{ParameterError, Signal, stabilizers::SlopeBound as Law};

use super::kind::{Anywhere, Install, OnLoops, StabilizerKind};
use super::table::table;
use super::{Basis, Manner, Pledge, Search};

table! {
    /// A bound of the slope: forces that change no faster with the displacement.
    SlopeBound = "slope-bound" {
        words {}
        numbers {
            /// Largest slope of the force in N/m, greater than 0; default: 2 b / (T (1 + 2 d)) with the damping b of
            /// the device and d ticks of delay.
            slope: Positive, "N/m", "slope = 1000.0  # N/m",
            |_, on| on.burns() / on.lateness(),
            |at, _| Search::ratios(0.01 * at, 10.0 * at);
            /// Rate at which a force that is held back comes through in N/s, 0 or more; default 0.
            creep: NonNegative, "N/s", "creep = 0.0  # N/s", |_, _| 0.0, |_, _| None;
        }
    }
}

impl StabilizerKind for SlopeBound {
    fn pledge(&self, _on: &Basis) -> Pledge {
        Pledge { manner: Manner::Cuts, ..Pledge::POPC }
    }

    fn adds_damping(&self) -> bool {
        false
    }

    fn lacks(&self, on: &Basis) -> Option<&'static str> {
        self.slope.is_none().then(|| on.undamped()).flatten()
    }
}

impl Anywhere for SlopeBound {
    fn make<V: Signal, R: Install<V>>(
        on: OnLoops<'_, Self>,
        to: R,
    ) -> Result<R::Made, ParameterError> {
        let bound = Law::<V>::new(on.each(Self::slope))?;
        Ok(to.behind(bound.creeping(on.each(Self::creep))?))
    }
}
