//! The tables of a teleoperator file.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::files::scene::{
    Cap, DelayTicks, Finite, NonNegative, Positive, Probability, Seed, Share,
};

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
    /// Position of master and slave at t = 0, in m, other than 0, so that the hand's spring stores energy; required.
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
    /// Environment that it touches; default: none.
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
    /// Damping in N.s/m, 0 or more; default 0, with which wave variables need an impedance of their own.
    #[serde(default)]
    pub damping: NonNegative,
}

/// A channel in each direction; the two are alike and independent of each other.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Channel {
    /// Delay one way in whole servo ticks, 0 to 1024; default 0.
    pub delay: DelayTicks,
    /// Largest further delay of a message in ticks, 0 to 1024, all numbers equally likely; default 0.
    pub spread: DelayTicks,
    /// Probability that a message is lost, 0 to 1; default 0.
    pub loss: Probability,
    /// Seed of the random numbers, a whole number of 0 or more; required with `spread` or `loss`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub seed: Option<Seed>,
}

/// Settings of the stabilizers of a teleoperator: what several share, and a table of each that has more.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Stabilizer {
    /// Limit of what is injected, 0 or more, inf for no limit: of a damping at the master in m / T, of a mobility at
    /// the slave in 1 / ((K + B / T) T), with K and B the coordination's; default 0.5.
    pub damping_cap: Cap,
    /// Settings of `drift-compensated`.
    #[serde(rename = "drift-compensated")]
    pub drift_compensated: DriftCompensated,
    /// Settings of `two-layer`.
    #[serde(rename = "two-layer")]
    pub two_layer: TwoLayer,
    /// Settings of `wave-variables` and of the stabilizers whose names begin with it.
    #[serde(rename = "wave-variables")]
    pub wave_variables: WaveVariables,
}

/// Settings of drift compensation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct DriftCompensated {
    /// Speed in m/s with which drift is taken back, 0 or more; default 0.
    pub speed: NonNegative,
}

/// Settings of the two-layer architecture, whose tanks are empty at the start.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct TwoLayer {
    /// Energy in J up to which the master's damper fills its tank, greater than 0; default: what the hand stores at the
    /// start.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub level: Option<Positive>,
    /// Damping at the master for each joule that its tank lacks, in N.s/(m J), 0 or more; default: the damping that the
    /// coordination's damper and its spring need over the channel, at most damping_cap m / T, for an empty tank.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gain: Option<NonNegative>,
    /// Share of its tank that each end sends on a tick, greater than 0 and at most 1; default 0.1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub share: Option<Share>,
}

/// Settings of the wave variables.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct WaveVariables {
    /// Impedance b in N.s/m, greater than 0; default: the coordination's damping.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub impedance: Option<Positive>,
    /// Time constant of the wave filter in s, 0 or more; default: a tenth of the longest way there and back.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub filter_time: Option<NonNegative>,
}
