//! Values that a number of an own stabilizer may have.

use super::super::super::quantity::{Cap, Finite, NonNegative, Positive, Quantity, Ticks};
use crate::files::scene::OutOfRange;

/// The values that a number may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Allowed {
    /// Finite and greater than 0.
    Positive,
    /// Finite, 0 or greater.
    NonNegative,
    /// Finite.
    Finite,
    /// 0 or greater; infinity means that there is no limit.
    Limit,
    /// A whole number from 1 to 1000000: a number of servo ticks.
    Ticks,
}

impl Allowed {
    /// The number, if it is one of them.
    pub(super) fn check(self, number: f64) -> Result<f64, OutOfRange> {
        match self {
            Self::Positive => Positive::of(number).map(Quantity::number),
            Self::NonNegative => NonNegative::of(number).map(Quantity::number),
            Self::Finite => Finite::of(number).map(Quantity::number),
            Self::Limit => Cap::of(number).map(Quantity::number),
            Self::Ticks => Ticks::of(number).map(Quantity::number),
        }
    }

    /// Whether they are whole.
    pub(super) fn is_whole(self) -> bool {
        self == Self::Ticks
    }

    /// A value to show in messages, as TOML.
    pub(super) fn example(self) -> &'static str {
        match self {
            Self::Ticks => "4",
            _ => "1.0",
        }
    }
}
