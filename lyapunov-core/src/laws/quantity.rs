//! Quantities that the laws look at, with their units.

/// Quantity that a law looks at.
///
/// ```
/// use lyapunov_core::{Stabilizer, laws};
/// # use lyapunov_core::{Correction, PortSample};
/// # #[derive(Clone)]
/// # struct Pull;
/// # impl Stabilizer<f64> for Pull {
/// #     fn stabilize(&mut self, sample: &PortSample<f64>, effort: f64) -> Correction<f64> {
/// #         Correction::none(effort - sample.velocity).checked()
/// #     }
/// # }
/// let broken = laws::stabilizer(&Pull, laws::Samples::new(1e-3)).unwrap_err();
/// assert_eq!(broken.quantity.name, "power that the correction takes out of the motion");
/// assert_eq!(broken.quantity.unit, "W");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quantity {
    /// Its name, for a message.
    pub name: &'static str,
    /// Its SI unit; empty where it has none, or one that the law does not know.
    pub unit: &'static str,
}

macro_rules! quantities {
    ($($constant:ident: $name:literal in $unit:literal;)+) => {
        $(pub(super) const $constant: &Quantity = &Quantity { name: $name, unit: $unit };)+
    };
}

quantities! {
    DECREASE: "decrease" in "J";
    DECREASE_AT_REST: "decrease at rest" in "J";
    NEXT_DECREASE: "next decrease" in "J";
    ENERGY_VALUE: "V" in "J";
    SUM_OF_DECREASES: "sum of the decreases" in "J";
    ROOM_IN_LIMIT: "limit less the correction" in "N";
    POWER_NOT_TOLD: "power taken less that of the damping told" in "W";
    ACCOUNT: "account" in "J";
    VALUE_AT_REST: "V at rest" in "";
    VALUE: "V" in "";
    GRADIENT: "gradient" in "";
    EFFORT: "effort" in "N";
    FIRST_DISPLACEMENT: "first displacement" in "m";
    FIRST_WORK: "first work" in "J";
    POSITION: "position" in "m";
    SAMPLE: "sample" in "";
    APPLIED_EFFORT: "applied effort" in "N";
    DISPLACEMENT: "displacement" in "m";
    WORK: "work" in "J";
    OBSERVED_ENERGY: "observed energy" in "J";
    DAMPING: "damping" in "N·s/m";
    SHORTFALL: "shortfall" in "J";
    ACCEPTANCE: "acceptance of a sound sample" in "";
    SERVED: "served energy with the shortfall" in "J";
    POWER_TAKEN: "power that the correction takes out of the motion" in "W";
    ROOM_IN_EFFORT: "room left by the effort" in "N";
    REJECTION: "rejection" in "";
    NEXT_EFFORT: "next effort" in "N";
    NEXT_ACCEPTANCE: "acceptance of the next sample" in "";
    VELOCITY: "velocity" in "m/s";
    NEXT_VELOCITY: "next velocity" in "m/s";
    VELOCITY_AFTER_RESTART: "velocity after a restart" in "m/s";
    RESTORED: "acceptance of its own state" in "";
    NEXT_STATE: "sameness of the states after it" in "";
    RESULT: "result" in "";
    ORDER: "order" in "";
}
