//! Who takes part.

/// What stabilizes the port of a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Entrant {
    /// Nothing.
    None,
    /// The passivity observer/controller, which sums what the input takes from V.
    Popc,
    /// The Lyapunov observer/controller over all that V loses.
    Decrease,
    /// The same with V asked to decay.
    Decay,
}

impl Entrant {
    /// All, in the order of the rows.
    pub const ALL: [Self; 4] = [Self::None, Self::Popc, Self::Decrease, Self::Decay];

    /// What it is called.
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Popc => "popc",
            Self::Decrease => "lolc-decrease",
            Self::Decay => "lolc-decay",
        }
    }
}
