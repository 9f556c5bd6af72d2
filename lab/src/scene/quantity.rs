//! Numbers that were checked when they were made, so that a field's type is its rule.

use std::fmt;

use serde::{Deserialize, Serialize};

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

macro_rules! quantity {
    ($(#[$attribute:meta])* $name:ident, $rule:literal, $accepts:expr) => {
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
                    // The sum turns -0.0 into 0.0, whose sign would otherwise travel into the results.
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
    };
}

quantity!(
    /// A finite number greater than 0: a rate, a duration, a device's mass, a resolution, a force limit.
    Positive,
    "finite and greater than 0",
    |value| value.is_finite() && value > 0.0
);

quantity!(
    /// A finite number of 0 or more: a damping, a stiffness, an operator's mass.
    #[derive(Default)]
    NonNegative,
    "finite and 0 or greater",
    |value| value.is_finite() && value >= 0.0
);

quantity!(
    /// Any finite number: a position, a velocity.
    #[derive(Default)]
    Finite,
    "finite",
    |value| value.is_finite()
);

quantity!(
    /// A limit of 0 or more; infinity means that there is no limit.
    Cap,
    "0 or greater (inf is allowed)",
    |value| value >= 0.0
);

impl Default for Cap {
    /// Half of m / T, which keeps the paper's loops bounded.
    fn default() -> Self {
        Self(0.5)
    }
}

/// A delay in whole servo ticks, from 0 to [`DelayTicks::MOST`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(try_from = "i64", into = "u16")]
pub struct DelayTicks(u16);

impl DelayTicks {
    /// The longest delay.
    pub const MOST: u16 = 1024;

    /// Accepts a whole number from 0 to 1024.
    ///
    /// # Errors
    /// Any other number.
    pub fn new(ticks: i64) -> Result<Self, OutOfRange> {
        match u16::try_from(ticks) {
            Ok(ticks) if ticks <= Self::MOST => Ok(Self(ticks)),
            _ => Err(OutOfRange {
                rule: "a whole number from 0 to 1024",
                value: Given::Whole(ticks),
            }),
        }
    }

    /// The plain number.
    pub fn get(self) -> u16 {
        self.0
    }
}

impl TryFrom<i64> for DelayTicks {
    type Error = OutOfRange;

    fn try_from(ticks: i64) -> Result<Self, OutOfRange> {
        Self::new(ticks)
    }
}

impl From<DelayTicks> for u16 {
    fn from(ticks: DelayTicks) -> u16 {
        ticks.0
    }
}
