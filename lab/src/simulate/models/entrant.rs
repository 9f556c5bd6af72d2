//! Entrants of a model's comparison.

use crate::text::names::Named;

/// Stabilizer at the port of a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Entrant {
    /// No stabilizer.
    None,
    /// The passivity observer/controller, which sums what the input takes from V.
    Popc,
    /// The Lyapunov observer/controller, which sums all that V loses.
    Decrease,
    /// The same, with V required to decay.
    Decay,
}

impl Named for Entrant {
    const KIND: &'static str = "a model";

    const ALL: &'static [Self] = &[Self::None, Self::Popc, Self::Decrease, Self::Decay];

    fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Popc => "popc",
            Self::Decrease => "lolc-decrease",
            Self::Decay => "lolc-decay",
        }
    }
}
