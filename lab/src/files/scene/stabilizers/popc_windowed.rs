//! The passivity observer/controller with a credit that expires.

use lyapunov::{ParameterError, Popc, PortEnergy, Signal};
use lyapunov::{accumulators::Plain, stabilizers::WindowedCredit};

use super::basis::SLOTS;
use super::kind::{Anywhere, Install, OnLoops, StabilizerKind};
use super::table::table;
use super::{Basis, Pledge, Search};

/// Share of a tick by which a slot may exceed whole ticks, as for an instant of a scene.
const ROUNDING: f64 = 1e-9;

table! {
    /// The passivity observer/controller, whose stored credit expires.
    PopcWindowed = "popc-windowed" {
        words {}
        numbers {
            damping_cap;
            /// Time after which credit expires in s, greater than 0, in 8 slots; default: one swing of the hand.
            window: Positive, "s", "window = 0.5  # s",
            |_, on| on.swing, |at, on| Search::ratios(SLOTS as f64 * on.limit.period, 10.0 * at);
        }
    }
}

impl StabilizerKind for PopcWindowed {
    fn pledge(&self, _on: &Basis) -> Pledge {
        Pledge::FORGETFUL
    }

    fn promises(&self) -> bool {
        true
    }

    /// The ticks of a slot, rounded up.
    fn shape(&self, on: &Basis) -> u32 {
        let ticks = self.window(on) / (SLOTS as f64 * on.limit.period);
        // The conversion saturates: no run leaves a longer slot either.
        (ticks - ROUNDING).ceil().max(1.0) as u32
    }
}

impl Anywhere for PopcWindowed {
    fn make<V: Signal, R: Install<V>>(
        on: OnLoops<'_, Self>,
        to: R,
    ) -> Result<R::Made, ParameterError> {
        let popc = Popc::<V::Scalar>::new(PortEnergy, on.limit(Self::damping_cap)?);
        let sum = WindowedCredit::<V::Scalar, Plain<V::Scalar>, SLOTS>::of_ticks(on.shape())?;
        Ok(to.behind(popc.summed_by(sum)))
    }
}

#[cfg(test)]
mod tests {
    use super::super::Stabilizer;
    use super::*;

    #[test]
    fn a_slot_of_whole_ticks_is_not_rounded_up() {
        // 0.56 / (8 · 0.01) is 7.000000000000001 in f64.
        for (window, ticks) in [(0.56, 7), (0.561, 8), (0.08, 1), (0.001, 1)] {
            let text = format!(
                "duration = 1\nservo_rate = 100\ndevice.mass = 1\nenvironment.wall.stiffness = 100\n\
                 stabilizer.popc-windowed.window = {window}\n"
            );
            let scene = crate::files::scene::Scene::parse(&text, "test").expect("a scene");
            let Some(Stabilizer::PopcWindowed(own)) = scene.stabilizer else { panic!("{text}") };
            assert_eq!(own.shape(&Basis::of(&scene)), ticks, "{window}");
        }
    }
}
