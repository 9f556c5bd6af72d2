//! What a column of a log holds.

use serde::Serialize;

/// What a column of a log holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Role {
    /// Time, s.
    T,
    /// Position, m.
    X,
    /// The environment's force on the device from this row until the next, N.
    F,
    /// Velocity, m/s.
    V,
}

impl Role {
    /// All of them, in the order in which columns are given.
    pub const ALL: [Self; 4] = [Self::T, Self::X, Self::F, Self::V];

    /// The letter by which a command line names it.
    pub fn letter(self) -> &'static str {
        match self {
            Self::T => "t",
            Self::X => "x",
            Self::F => "f",
            Self::V => "v",
        }
    }

    pub(super) fn index(self) -> usize {
        self as usize
    }
}
