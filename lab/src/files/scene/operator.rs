//! The operator's hand and its motion.

use std::path::PathBuf;
use std::sync::Arc;

use schemars::JsonSchema;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize};

use super::coordinates::Coordinates;
use super::quantity::{Finite, NonNegative};

/// The operator's hand: a mass, a damper and a spring to a point of rest, moving with the device as one unless a link
/// joins them.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Operator {
    /// Mass in kg, 0 or more, with a link greater than 0; default 0.
    pub mass: NonNegative,
    /// Damping in N.s/m, 0 or more; default 0.
    pub damping: NonNegative,
    /// Stiffness of the spring in N/m, 0 or more; default 0.
    pub stiffness: NonNegative,
    /// Position in m at which the spring is at rest; default 0.
    pub rest: Coordinates,
    /// How the point of rest moves; default: it does not.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub motion: Option<Motion>,
    /// How stiffness and damping change; default: they do not.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub grip: Option<Grip>,
}

/// How the point of rest moves, held over each servo tick.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Motion {
    /// To another point, at once.
    Step {
        /// When, in s; default 0.
        #[serde(default)]
        at: NonNegative,
        /// Where to, in m; required.
        to: Finite,
    },
    /// To another point, steadily.
    Ramp {
        /// From when on, in s; default 0.
        #[serde(default)]
        at: NonNegative,
        /// Where to, in m; required.
        to: Finite,
        /// How fast, in m/s, 0 or more; required.
        rate: NonNegative,
    },
    /// To and fro: rest + amplitude sin(2 pi frequency t).
    Sine {
        /// How far, in m; required.
        amplitude: Finite,
        /// How often, in Hz, 0 or more; required.
        frequency: NonNegative,
    },
    /// As recorded.
    File {
        /// A CSV file with the columns t,rest in s and m, linear between rows and constant outside them; its path is
        /// taken from the folder of the scene; required.
        path: PathBuf,
        /// The rows of the file: t in s and rest in m.
        #[serde(skip)]
        samples: Arc<[(f64, f64)]>,
    },
}

/// The keys of every kind of motion.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Keys {
    kind: Kind,
    at: Option<NonNegative>,
    to: Option<Finite>,
    rate: Option<NonNegative>,
    amplitude: Option<Finite>,
    frequency: Option<NonNegative>,
    path: Option<PathBuf>,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Kind {
    Step,
    Ramp,
    Sine,
    File,
}

impl<'de> Deserialize<'de> for Motion {
    /// Written by hand so that faults keep their place: a derived tagged enum reads all keys before it checks the
    /// first.
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Keys { kind, at, to, rate, amplitude, frequency, path } =
            Keys::deserialize(deserializer)?;
        let known: &'static [&'static str] = match kind {
            Kind::Step => &["kind", "at", "to"],
            Kind::Ramp => &["kind", "at", "to", "rate"],
            Kind::Sine => &["kind", "amplitude", "frequency"],
            Kind::File => &["kind", "path"],
        };
        let given = [
            ("at", at.is_some()),
            ("to", to.is_some()),
            ("rate", rate.is_some()),
            ("amplitude", amplitude.is_some()),
            ("frequency", frequency.is_some()),
            ("path", path.is_some()),
        ];
        if let Some((key, _)) = given.iter().find(|(key, given)| *given && !known.contains(key)) {
            return Err(D::Error::custom(format_args!(
                "has `{key}`, which this kind of motion does not know; its keys are: {}",
                known.join(", ")
            )));
        }
        let missing = D::Error::missing_field;
        let (at, to) = (at.unwrap_or_default(), to.ok_or_else(|| missing("to")));
        Ok(match kind {
            Kind::Step => Self::Step { at, to: to? },
            Kind::Ramp => Self::Ramp { at, to: to?, rate: rate.ok_or_else(|| missing("rate"))? },
            Kind::Sine => Self::Sine {
                amplitude: amplitude.ok_or_else(|| missing("amplitude"))?,
                frequency: frequency.ok_or_else(|| missing("frequency"))?,
            },
            Kind::File => {
                Self::File { path: path.ok_or_else(|| missing("path"))?, samples: Arc::from([]) }
            }
        })
    }
}

/// How the operator's stiffness and damping change: constant from each time on, the operator's own before the first.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Grip {
    /// When they change, in s, one after the other; required.
    pub times: Vec<NonNegative>,
    /// Stiffness of the operator's spring from each time on, in N/m, 0 or more; required.
    pub stiffness: Vec<NonNegative>,
    /// Damping of the operator from each time on, in N.s/m, 0 or more; required.
    pub damping: Vec<NonNegative>,
}
