//! Numbers checked when they are made, so that a field's type is its rule.

use std::fmt;

use lyapunov::Scalar;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize};

/// A value that its quantity does not allow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutOfRange {
    rule: &'static str,
    value: Given,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Given {
    Real(f64),
    Whole(i64),
}

impl fmt::Display for OutOfRange {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "must be {}, not ", self.rule)?;
        match self.value {
            Given::Real(value) => write!(formatter, "{value:?}"),
            Given::Whole(value) => write!(formatter, "{value}"),
        }
    }
}

impl std::error::Error for OutOfRange {}

/// The schema of a quantity: its rule, inline wherever the quantity stands.
macro_rules! schema {
    ($name:ident, $schema:tt) => {
        impl JsonSchema for $name {
            fn inline_schema() -> bool {
                true
            }

            fn schema_name() -> std::borrow::Cow<'static, str> {
                stringify!($name).into()
            }

            fn json_schema(_: &mut SchemaGenerator) -> Schema {
                json_schema!($schema)
            }
        }
    };
}

/// A checked number of a scene, whole or not.
pub(crate) trait Quantity: Copy + Sized {
    /// Whether it is whole.
    const IS_WHOLE: bool;

    /// Accepts a number that it allows.
    ///
    /// # Errors
    /// Any other number.
    fn of(number: f64) -> Result<Self, OutOfRange>;

    /// The plain number.
    fn number(self) -> f64;
}

macro_rules! quantity {
    ($(#[$attribute:meta])* $name:ident, $rule:literal, $schema:tt, $accepts:expr) => {
        $(#[$attribute])*
        #[derive(Clone, Copy, Debug, PartialEq, PartialOrd, Serialize, Deserialize)]
        #[serde(try_from = "f64", into = "f64")]
        pub struct $name(f64);

        impl $name {
            #[doc = concat!("Accepts a value that is ", $rule, ".")]
            ///
            /// # Errors
            /// Any other value.
            pub fn new(value: f64) -> Result<Self, OutOfRange> {
                let accepts: fn(f64) -> bool = $accepts;
                if accepts(value) {
                    // The sum turns -0.0 into 0.0, whose sign would otherwise reach the results.
                    Ok(Self(value + 0.0))
                } else {
                    Err(OutOfRange { rule: $rule, value: Given::Real(value) })
                }
            }

            /// The plain number.
            pub fn get(self) -> f64 {
                self.0
            }
        }

        impl TryFrom<f64> for $name {
            type Error = OutOfRange;

            fn try_from(value: f64) -> Result<Self, OutOfRange> {
                Self::new(value)
            }
        }

        impl From<$name> for f64 {
            fn from(quantity: $name) -> f64 {
                quantity.0
            }
        }

        impl Quantity for $name {
            const IS_WHOLE: bool = false;

            fn of(number: f64) -> Result<Self, OutOfRange> {
                Self::new(number)
            }

            fn number(self) -> f64 {
                self.0
            }
        }

        schema!($name, $schema);
    };
}

quantity!(
    /// A finite number greater than 0: a rate, a duration, a device's mass, a resolution, a force limit.
    Positive,
    "finite and greater than 0",
    { "type": "number", "exclusiveMinimum": 0 },
    |value| value.is_finite() && value > 0.0
);

impl Positive {
    /// A number checked when the program is compiled.
    pub(super) const fn known(value: f64) -> Self {
        assert!(value > 0.0 && value.is_finite(), "above 0 and finite");
        Self(value)
    }
}

quantity!(
    /// A finite number of 0 or more: a damping, a stiffness, an operator's mass.
    #[derive(Default)]
    NonNegative,
    "finite and 0 or greater",
    { "type": "number", "minimum": 0 },
    |value| value.is_finite() && value >= 0.0
);

quantity!(
    /// Any finite number: a position, a velocity.
    #[derive(Default)]
    Finite,
    "finite",
    { "type": "number" },
    |value| value.is_finite()
);

quantity!(
    /// A limit of 0 or more; infinity means that there is no limit.
    Cap,
    "0 or greater (inf is allowed)",
    // JSON has no infinity: converters from TOML to JSON write null.
    { "anyOf": [{ "type": "number", "minimum": 0 }, { "const": null }] },
    |value| value >= 0.0
);

impl Default for Cap {
    /// Half of m / T, which keeps the paper's loops bounded.
    fn default() -> Self {
        Self(0.5)
    }
}

quantity!(
    /// A limit greater than 0; infinity means that there is no limit.
    PositiveLimit,
    "greater than 0 (inf is allowed)",
    { "anyOf": [{ "type": "number", "exclusiveMinimum": 0 }, { "const": null }] },
    |value| value > 0.0
);

quantity!(
    /// A share of a whole, which is not nothing.
    Share,
    "greater than 0 and at most 1",
    { "type": "number", "exclusiveMinimum": 0, "maximum": 1 },
    |value| value > 0.0 && value <= 1.0
);

quantity!(
    /// A number from 0 to 1.
    #[derive(Default)]
    Probability,
    "from 0 to 1",
    { "type": "number", "minimum": 0, "maximum": 1 },
    |value| (0.0..=1.0).contains(&value)
);

macro_rules! whole {
    ($(#[$attribute:meta])* $name:ident, $whole:ty, $rule:literal, $schema:tt, $range:expr) => {
        $(#[$attribute])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
        #[serde(try_from = "i64", into = "i64")]
        pub struct $name($whole);

        impl $name {
            #[doc = concat!("Accepts ", $rule, ".")]
            ///
            /// # Errors
            /// Any other number.
            pub fn new(value: i64) -> Result<Self, OutOfRange> {
                match <$whole>::try_from(value) {
                    Ok(whole) if ($range).contains(&whole) => Ok(Self(whole)),
                    _ => Err(OutOfRange { rule: $rule, value: Given::Whole(value) }),
                }
            }

            /// The plain number.
            pub fn get(self) -> $whole {
                self.0
            }
        }

        impl TryFrom<i64> for $name {
            type Error = OutOfRange;

            fn try_from(value: i64) -> Result<Self, OutOfRange> {
                Self::new(value)
            }
        }

        impl From<$name> for i64 {
            fn from(quantity: $name) -> i64 {
                quantity.0.try_into().unwrap_or(i64::MAX)
            }
        }

        impl Quantity for $name {
            const IS_WHOLE: bool = true;

            fn of(number: f64) -> Result<Self, OutOfRange> {
                let rule = OutOfRange { rule: $rule, value: Given::Real(number) };
                // The conversion saturates, and what is refused is told as it was given.
                let whole = number as i64;
                if whole as f64 == number { Self::new(whole) } else { Err(rule) }
            }

            fn number(self) -> f64 {
                self.0 as f64
            }
        }

        schema!($name, $schema);
    };
}

whole!(
    /// A delay in whole servo ticks.
    #[derive(Default)]
    DelayTicks,
    u16,
    "a whole number from 0 to 1024",
    { "type": "integer", "minimum": 0, "maximum": 1024 },
    0..=1024
);

whole!(
    /// The interval from one call of a controller to the next, in whole servo ticks.
    HoldTicks,
    u16,
    "a whole number from 1 to 1024",
    { "type": "integer", "minimum": 1, "maximum": 1024 },
    1..=1024
);

impl Default for HoldTicks {
    fn default() -> Self {
        Self(1)
    }
}

whole!(
    /// The greatest length of an adaptive window in whole servo ticks.
    WindowTicks,
    u16,
    "a whole number from 1 to 256",
    { "type": "integer", "minimum": 1, "maximum": 256 },
    1..=256
);

whole!(
    /// The steps of an integrator from one servo tick to the next.
    StepsPerTick,
    u32,
    "a whole number from 1 to 1000000",
    { "type": "integer", "minimum": 1, "maximum": 1_000_000 },
    1..=1_000_000
);

impl Default for StepsPerTick {
    fn default() -> Self {
        Self(1)
    }
}

whole!(
    /// A number of servo ticks over which something happens.
    Ticks,
    u32,
    "a whole number from 1 to 1000000",
    { "type": "integer", "minimum": 1, "maximum": 1_000_000 },
    1..=1_000_000
);

whole!(
    /// The dimensions of a space.
    Dimensions,
    u8,
    "2 or 3",
    { "type": "integer", "minimum": 2, "maximum": 3 },
    2..=3
);

whole!(
    /// The seed of a random effect, up to the largest whole number of TOML.
    Seed,
    u64,
    "a whole number of 0 or more",
    { "type": "integer", "minimum": 0, "maximum": i64::MAX },
    0..=u64::MAX
);

/// A list of exactly two values.
pub(crate) fn two<'de, D, T>(deserializer: D) -> Result<[T; 2], D::Error>
where
    D: Deserializer<'de>,
    T: Deserialize<'de>,
{
    <[T; 2]>::try_from(Vec::deserialize(deserializer)?).map_err(|list: Vec<T>| {
        D::Error::custom(format_args!("must be a list of two numbers, not of {}", list.len()))
    })
}

/// A quantity of a scene in the scalar of its loop.
pub(crate) fn of<T: Scalar>(quantity: impl Into<f64>) -> T {
    T::of(quantity.into())
}
