//! Imperfections and disturbances of a loop.

use lyapunov::{ParameterError, trajectories};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::quantity::{DelayTicks, Finite, NonNegative, Positive, Probability, Seed, WindowTicks};

/// Effects simulated besides the loop itself; an absent one is not simulated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Effects {
    /// The position is measured in steps.
    pub encoder: Option<Encoder>,
    /// The force acts late.
    pub delay: Option<Delay>,
    /// The force is limited.
    pub saturation: Option<Saturation>,
    /// The velocity is filtered.
    pub filter: Option<Filter>,
    /// The position is measured with noise.
    pub noise: Option<Noise>,
    /// The ticks are not evenly spaced.
    pub jitter: Option<Jitter>,
    /// Answers of the environment are lost.
    pub dropout: Option<Dropout>,
    /// The device rubs.
    pub friction: Option<Friction>,
    /// A constant force acts on the device.
    pub load: Option<Load>,
    /// A force acts on the device for a while.
    pub pulse: Option<Pulse>,
}

/// A position measured in steps: round(x / resolution) resolution, ties away from zero.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Encoder {
    /// Size of a step in m, greater than 0; required.
    pub resolution: Positive,
}

/// A force that acts some ticks after it was commanded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Delay {
    /// Delay in servo ticks, a whole number from 0 to 1024; required.
    pub ticks: DelayTicks,
}

/// A force limited to the same size in both directions.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Saturation {
    /// Largest force in N, greater than 0; required.
    pub force: Positive,
}

/// Filter that estimates the velocity from positions, in place of the plain backward difference.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Filter {
    /// A first-order low pass behind the difference; its cutoff in Hz, greater than 0.
    Cutoff(Positive),
    /// An adaptive first-order window; its greatest length in servo ticks, from 1 to 256.
    Window(WindowTicks),
}

/// Gaussian noise on the position, before the encoder.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Noise {
    /// Standard deviation in m, 0 or more; required.
    pub deviation: NonNegative,
    /// Seed, a whole number of 0 or more; required.
    pub seed: Seed,
}

/// Gaussian jitter of the interval from tick to tick.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Jitter {
    /// Standard deviation in s, 0 or more; required.
    pub deviation: NonNegative,
    /// Seed, a whole number of 0 or more; required.
    pub seed: Seed,
}

/// Answers of the environment that are lost by chance.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Dropout {
    /// Probability that an answer is lost, from 0 to 1; required.
    pub probability: Probability,
    /// Seed, a whole number of 0 or more; required.
    pub seed: Seed,
    /// Force in place of a lost answer; required.
    pub policy: Policy,
}

/// Force in place of a lost answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Policy {
    /// The last answer that arrived; none before the first.
    Hold,
    /// None.
    Zero,
}

/// Friction on the device: (coulomb + (static - coulomb) exp(-(v / stribeck_velocity)^2)) against the motion, and sticking
/// where the other forces are no larger than `static`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Friction {
    /// Force at high speed in N, 0 or more; required.
    pub coulomb: NonNegative,
    /// Force that holds the device at rest in N, no less than `coulomb`, which is the default.
    #[serde(default, rename = "static", skip_serializing_if = "Option::is_none")]
    pub breakaway: Option<NonNegative>,
    /// Speed in m/s at which the force has come down from `static` by 63 % of the way, greater than 0; required where
    /// `static` is more than `coulomb`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stribeck_velocity: Option<Positive>,
}

impl Friction {
    /// The force that holds the device at rest, N, or its default.
    pub fn breakaway(&self) -> f64 {
        self.breakaway.unwrap_or(self.coulomb).get()
    }
}

/// A constant force on the device, in +x.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Load {
    /// Force in N; required.
    pub force: Finite,
}

/// A force on the device for a while, in +x.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Pulse {
    /// Start in s, 0 or more; required.
    pub start: NonNegative,
    /// Duration in s, 0 or more; required.
    pub duration: NonNegative,
    /// Force in N; required.
    pub force: Finite,
}

impl Pulse {
    /// The force, N, on the ticks of a servo rate, Hz.
    pub(crate) fn on_ticks(&self, rate: f64) -> Result<trajectories::Pulse, ParameterError> {
        trajectories::Pulse::new(self.force.get(), self.start.get(), self.duration.get(), rate)
    }
}
