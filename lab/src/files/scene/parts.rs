//! The smaller tables and the words of a scene file.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::coordinates::Coordinates;
use super::quantity::{Dimensions, NonNegative, Positive};

/// Source of the velocity v(n).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Velocity {
    /// v(n) = (xm(n) - xm(n-1)) / T from the measured position; 0 at n = 0.
    #[default]
    BackwardDifference,
    /// The plant's own velocity, untouched by the encoder, also at n = 0.
    Exact,
}

/// Number type that a run computes in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Scalar {
    /// Double precision.
    #[default]
    F64,
    /// Single precision.
    F32,
}

impl Scalar {
    /// Its word in a file and in messages.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::F64 => "f64",
            Self::F32 => "f32",
        }
    }
}

/// The haptic device.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Device {
    /// Mass in kg, greater than 0; required.
    pub mass: Positive,
    /// Damping in N.s/m, 0 or more; default 0.
    #[serde(default)]
    pub damping: NonNegative,
}

/// State of the plant at t = 0.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Initial {
    /// Position in m; default 0.
    pub position: Coordinates,
    /// Velocity in m/s; default 0.
    pub velocity: Coordinates,
}

/// Elastic joint of operator and device, which are then two masses: a spring and a damper, relaxed where both are at one place.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Link {
    /// Stiffness in N/m, greater than 0; required.
    pub stiffness: Positive,
    /// Damping in N.s/m, 0 or more; default 0.
    #[serde(default)]
    pub damping: NonNegative,
}

/// The space that a scene is in, where it is not a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Space {
    /// Its dimensions, 2 or 3; required.
    pub dimensions: Dimensions,
}
