//! The stabilizers of scene files.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::quantity::Cap;

/// What watches the port and keeps the loop bounded.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Stabilizer {
    /// The Lyapunov observer/controller.
    Lolc(Lolc),
    /// The passivity observer/controller.
    Popc(Popc),
}

/// The Lyapunov observer/controller, which credits what its candidate knows to be burnt.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Lolc {
    /// How the port's work is booked; default: held.
    pub work: Work,
    /// What is credited beyond the port's work; default: the paper's mass-spring-damper.
    pub candidate: Candidate,
    /// What the energies are summed in; default: plain.
    pub ledger: Ledger,
    /// Limit of the injected damping in units of m / T, 0 or more, inf for no limit; default 0.5. A limit of 0 only
    /// observes.
    pub damping_cap: Cap,
}

/// The passivity observer/controller, whose candidate is the port's own energy.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Popc {
    /// How the port's work is booked; default: held.
    pub work: Work,
    /// What the energies are summed in; default: plain.
    pub ledger: Ledger,
    /// Limit of the injected damping in units of m / T, 0 or more, inf for no limit; default 0.5. A limit of 0 only
    /// observes.
    pub damping_cap: Cap,
}

/// How the work at the port is booked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Work {
    /// f_act(n-1) · dx(n): what crossed the port under a held force.
    #[default]
    Held,
    /// (f_env(n) v(n) + alpha(n-1) v(n-1)²) T: the paper's step 4.
    Sampled,
}

/// What the observer's energies are summed in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Ledger {
    /// One number of the loop's own scalar.
    #[default]
    Plain,
    /// Two of them: the sum and the rounding error it has made.
    Compensated,
    /// One that is wider: f64 where the loop is in f32, double-double where it is in f64.
    Wide,
}

/// What a Lyapunov observer credits beyond the port's work.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Candidate {
    /// What the environment's own damper burns, as a wall's b v² T while the device is beyond the surface; the paper's.
    #[default]
    MassSpringDamper,
    /// The device's own damping b v² T at every tick.
    DeviceDamping,
    /// Nothing.
    Spring,
}
