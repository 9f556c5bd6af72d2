//! A model file.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::plant::Plant;
use crate::files::scene::{
    Cap, Coordinates, DelayTicks, Finite, HoldTicks, MODEL, NonNegative, Positive, Scalar,
    StepsPerTick, schema_of,
};

/// A model file: a control-affine plant under its nominal controller, and the settings of its stabilizers.
///
/// [`Model::parse`] and [`Model::load`] return only models that pass [`Model::check`]. Call it again after changing a
/// field.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(
    title = "A model of lyapunov",
    description = "A control-affine plant under its nominal controller, and what its stabilizers are set to. SI units."
)]
pub struct Model {
    /// Simulated time in s, greater than 0; required.
    pub duration: Positive,
    /// Rate of the servo loop in Hz, greater than 0; required.
    pub servo_rate: Positive,
    /// Number type the run computes in; default: f64.
    #[serde(default)]
    pub scalar: Scalar,
    /// Steps of the classical Runge-Kutta method from one tick to the next; default: 1.
    #[serde(default)]
    pub steps_per_tick: StepsPerTick,
    /// The state at t = 0, counted from rest, a number for each state of the plant; required.
    #[schemars(length(min = 2, max = 4))]
    pub initial: Vec<Finite>,
    /// The plant and what its V is made of, exactly one; required.
    pub plant: Plant,
    /// The nominal controller; default: none.
    #[serde(default)]
    pub controller: Controller,
    /// What the stabilizers are set to.
    #[serde(default)]
    pub stabilizer: Stabilizer,
}

impl Model {
    /// Whether `text` is meant as a model rather than a scene: it has a table that only models have.
    pub fn is_in(text: &str) -> bool {
        MODEL.is_in(text)
    }

    /// Number of the last tick, N = round(duration · servo_rate), from 0 to 1e9; the run has N + 1 ticks.
    pub fn ticks(&self) -> u64 {
        (self.duration.get() * self.servo_rate.get()).round() as u64
    }
}

/// The JSON Schema (draft 7, which TOML editors know) of model files as the text of a file, generated from the types
/// that read them. It lacks the rules between values, which [`Model::check`] checks.
pub fn schema_text() -> String {
    format!("{:#}\n", schema_of::<Model>())
}

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

/// What the stabilizers of a model are set to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Stabilizer {
    /// Limit of the injected damping in units of m / T, with m the least apparent mass of the plant's port, 0 or more,
    /// inf for no limit; default 0.5.
    pub damping_cap: Cap,
    /// Rate c in 1/s at which V is asked to decay by the entrant that asks for it, 0 or more; default 0.
    pub decay: NonNegative,
}
