//! The virtual coupling.

use lyapunov::{ParameterError, Signal, stabilizers};

use super::kind::{Anywhere, Install, OnLoops, StabilizerKind};
use super::table::table;
use super::{Basis, Pace, Pledge, Search};

table! {
    /// Virtual coupling (Colgate, Stanley and Brown 1995): a spring and a damper between the device and a proxy, which
    /// touches the environment.
    VirtualCoupling = "virtual-coupling" {
        words {}
        numbers {
            /// Spring between device and proxy in N/m, greater than 0; default: b / (T (1 + 2 d)) with the damping b of
            /// the device and d ticks of delay.
            stiffness: Positive, "N/m", "stiffness = 500.0  # N/m",
            |_, on| 0.5 * on.burns() / on.lateness(),
            |at, _| Search::ratios(0.1 * at, 2.0 * at);
            /// Damper between device and proxy in N.s/m, 0 or more; default: half the damping of the device.
            damping: NonNegative, "N.s/m", "damping = 0.05  # N.s/m",
            |_, on| 0.5 * on.damping, |at, _| Search::up_to(2.0 * at);
            /// Damper on the proxy alone in N.s/m, 0 or more; default: k T / 2 + B of the environment at its own rate.
            drag: NonNegative, "N.s/m", "drag = 5.0  # N.s/m",
            |_, on| on.drag, |at, _| Search::ratios(0.1 * at, 10.0 * at);
        }
    }
}

impl StabilizerKind for VirtualCoupling {
    fn pledge(&self, _on: &Basis) -> Pledge {
        Pledge::ANSWERING
    }

    fn reports_damping(&self) -> bool {
        false
    }

    fn assumes(&self) -> Option<&'static str> {
        Some("a passive environment")
    }

    fn lacks(&self, on: &Basis) -> Option<&'static str> {
        self.stiffness.is_none().then(|| on.undamped()).flatten()
    }
}

impl Anywhere for VirtualCoupling {
    fn make<V: Signal, R: Install<V>>(
        on: OnLoops<'_, Self>,
        to: R,
    ) -> Result<R::Made, ParameterError> {
        let (stiffness, damping) = (on.each(Self::stiffness), on.each(Self::damping));
        let drag = on.each(Self::drag);
        let coupling = stabilizers::VirtualCoupling { stiffness, damping, drag };
        Ok(to.around(Pace::Servo, move |port| stabilizers::CoupledPort::new(port, coupling)))
    }
}
