//! The nominal controller of a model.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::files::scene::{Coordinates, DelayTicks, HoldTicks};

/// A proportional-derivative feedback: u = holding - proportional q - derivative q̇ for each input, computed at every
/// `hold`-th tick, held in between, and `delay` ticks late.
///
/// q are the first states of the plant, as many as it has inputs, and q̇ the same number after them; holding is what
/// keeps a posture against gravity, of a leg only. One input takes a number, two take a list.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Controller {
    /// Gains of the places, in N.m/rad or V/rad; default 0.
    pub proportional: Coordinates,
    /// Gains of the rates, in N.m.s/rad or V.s/rad; default 0.
    pub derivative: Coordinates,
    /// Whole servo ticks from one computation to the next, 1 to 1024; default 1.
    pub hold: HoldTicks,
    /// Delay in whole servo ticks, 0 to 1024; default 0.
    pub delay: DelayTicks,
}
