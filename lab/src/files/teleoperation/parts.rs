//! The tables of a teleoperator file.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::files::scene::{Cap, DelayTicks, Finite, NonNegative, Positive, Probability, Seed};

/// The master in the operator's hand, which pulls it from `start` to 0.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Master {
    /// Mass of device and hand together in kg, greater than 0; required.
    pub mass: Positive,
    /// Damping of both together in N.s/m, 0 or more; default 0.
    #[serde(default)]
    pub damping: NonNegative,
    /// Stiffness of the hand's spring in N/m, at rest at 0, greater than 0; required.
    pub hand_stiffness: Positive,
    /// Where master and slave stand at t = 0, in m, other than 0; required.
    pub start: Finite,
}

/// The slave.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Slave {
    /// Mass in kg, greater than 0; required.
    pub mass: Positive,
    /// Damping in N.s/m, 0 or more; default 0.
    #[serde(default)]
    pub damping: NonNegative,
    /// What it touches; default: nothing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wall: Option<Wall>,
}

/// A real, elastic wall: f = k p for the depth p = x - position > 0, else 0, at every instant.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Wall {
    /// Position of the surface in m, not before the start; default 0.
    #[serde(default)]
    pub position: Finite,
    /// Stiffness k in N/m, greater than 0; required.
    pub stiffness: Positive,
}

/// The slave's controller: a spring from the commanded position and a damper from the commanded velocity.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Coordination {
    /// Stiffness in N/m, greater than 0; required.
    pub stiffness: Positive,
    /// Damping in N.s/m, 0 or more; default 0.
    #[serde(default)]
    pub damping: NonNegative,
}

/// A channel in each direction; the two are alike and independent of each other.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Channel {
    /// Delay one way in whole servo ticks, 0 to 1024; default 0.
    pub delay: DelayTicks,
    /// How many ticks more a message may take, 0 to 1024, all numbers alike; default 0.
    pub spread: DelayTicks,
    /// Probability that a message is lost, 0 to 1; default 0.
    pub loss: Probability,
    /// Seed of the random numbers, a whole number of 0 or more; required with `spread` or `loss`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub seed: Option<Seed>,
}

/// What the stabilizers of a teleoperator are set to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Stabilizer {
    /// Limit of what is injected, 0 or more, inf for no limit: of a damping at the master in m / T, of a mobility at
    /// the slave in 1 / ((K + B / T) T), with K and B the coordination's; default 0.5.
    pub damping_cap: Cap,
    /// Speed in m/s with which drift is taken back, 0 or more; default 0.
    pub compensation_speed: NonNegative,
    /// Impedance of the wave variables in N.s/m, greater than 0; default: the coordination's damping.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wave_impedance: Option<Positive>,
}
