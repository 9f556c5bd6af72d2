//! Work, ledger and candidate of the two observers/controllers that scenes have chosen from the start.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Booking of the work at the port.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Work {
    /// f_act(n-1) · dx(n): what crossed the port under a held force.
    #[default]
    Held,
    /// (f_env(n) v(n) + alpha(n-1) v(n-1)²) T: the paper's step 4.
    Sampled,
}

impl Work {
    /// Its word in a scene file.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Held => "held",
            Self::Sampled => "sampled",
        }
    }
}

/// Accumulator of the observer's energies.
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

/// Credit of a Lyapunov observer beyond the port's work.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Candidate {
    /// Energy that the environment's own damper dissipates, as a wall's b v² T while the device is in contact; the
    /// paper's.
    #[default]
    MassSpringDamper,
    /// The device's own damping b v² T at every tick.
    DeviceDamping,
    /// Nothing.
    Spring,
}
