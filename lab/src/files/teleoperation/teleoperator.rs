//! A teleoperator file.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::parts::{Channel, Coordination, Master, Slave, Stabilizer};
use crate::files::scene::{Positive, Scalar, TELEOPERATOR, schema_of};

/// A teleoperator file: a master and a slave joined by a channel, and the settings of their stabilizers.
///
/// [`Teleoperator::parse`] and [`Teleoperator::load`] return only teleoperators that pass [`Teleoperator::check`]. Call
/// it again after changing a field.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(
    title = "A teleoperator of lyapunov",
    description = "A master and a slave joined by a channel, and what their stabilizers are set to. SI units."
)]
pub struct Teleoperator {
    /// Simulated time in s, greater than 0; required.
    pub duration: Positive,
    /// Rate of the servo loops at both ends in Hz, greater than 0; required.
    pub servo_rate: Positive,
    /// Number type the run computes in; default: f64.
    #[serde(default)]
    pub scalar: Scalar,
    /// The master and the hand that moves it; required.
    pub master: Master,
    /// The slave and what it touches; required.
    pub slave: Slave,
    /// The slave's controller; required.
    pub coordination: Coordination,
    /// Channel that carries messages, each way; default: at once, and all of them.
    #[serde(default)]
    pub channel: Channel,
    /// Settings of the stabilizers.
    #[serde(default)]
    pub stabilizer: Stabilizer,
}

impl Teleoperator {
    /// Whether `text` is meant as a teleoperator: it has a table that only teleoperators have.
    pub fn is_in(text: &str) -> bool {
        TELEOPERATOR.is_in(text)
    }

    /// Number of the last tick, N = round(duration · servo_rate), from 0 to 1e9; the run has N + 1 ticks.
    pub fn ticks(&self) -> u64 {
        (self.duration.get() * self.servo_rate.get()).round() as u64
    }
}

/// The JSON Schema (draft 7, which TOML editors know) of teleoperator files as the text of a file, generated from the
/// types that read them. It lacks the rules between values, which [`Teleoperator::check`] checks.
pub fn schema_text() -> String {
    format!("{:#}\n", schema_of::<Teleoperator>())
}
