//! Energy bounding.

use lyapunov::{ParameterError, Signal, stabilizers::EnergyBounding as Law};

use super::kind::{Anywhere, Install, OnLoops, StabilizerKind};
use super::table::table;
use super::{Basis, Credit, Manner, Pledge, Search};
use crate::files::scene::check::Conflict;

table! {
    /// Energy bounding (Kim and Ryu 2010): forces that hand back no more than the device's damping dissipates.
    EnergyBounding = "energy-bounding" {
        words {}
        numbers {
            /// Steepest wall that is felt in N/m, greater than 0; default: b / (T (1 + d)) with the damping b of the
            /// device and d ticks of delay.
            c1: Positive, "N/m", "c1 = 500.0  # N/m",
            |_, on| on.burns() / (1.0 + f64::from(on.delay)),
            |at, _| Search::ratios(0.01 * at, at);
            /// How fast energy may be handed back in N/m, greater than 0 and at most c1; default: c1.
            c2: Positive, "N/m", "c2 = 500.0  # N/m", |own, on| own.c1(on), |_, _| None;
        }
    }
}

impl StabilizerKind for EnergyBounding {
    fn pledge(&self, on: &Basis) -> Pledge {
        let credit = Credit::Moved { damping: on.damping, least: on.limit.period };
        Pledge { credit, manner: Manner::Follows, ..Pledge::POPC }
    }

    fn adds_damping(&self) -> bool {
        false
    }

    fn lacks(&self, on: &Basis) -> Option<&'static str> {
        self.c1.is_none().then(|| on.undamped()).flatten()
    }

    fn check(&self, on: &Basis) -> Result<(), Conflict> {
        let (c1, c2) = (self.c1(on), self.c2(on));
        if c2 <= c1 {
            return Ok(());
        }
        Err(Conflict::new(
            "stabilizer.energy-bounding.c2",
            format!("`stabilizer.energy-bounding.c2` = {c2:?} N/m is more than `c1` = {c1:?} N/m"),
            "on the way out the two bounds would not fit: give at most `c1`",
        ))
    }
}

impl Anywhere for EnergyBounding {
    fn make<V: Signal, R: Install<V>>(
        on: OnLoops<'_, Self>,
        to: R,
    ) -> Result<R::Made, ParameterError> {
        let law = Law::new(on.each(Self::c1), on.each(Self::c2))?;
        let law = law.on_damping(on.each(|_, on| on.damping), on.each(|_, on| on.limit.period))?;
        Ok(to.behind(if on.common().delay > 0 { law.with_bounded_fall() } else { law }))
    }
}
