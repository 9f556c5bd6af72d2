//! Entrants of a teleoperator's comparison.

/// Stabilizer of a teleoperator's link.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Entrant {
    /// No stabilizer.
    None,
    /// A passivity observer/controller at each port, which knows nothing of the other.
    Popc,
    /// The two-port passivity controller: each end may spend what the other reports as absorbed.
    TwoPort,
    /// The same, taking back the drift of the slave.
    Compensated,
    /// Wave variables.
    Waves,
}

impl Entrant {
    /// All entrants, in the order of the rows.
    pub const ALL: [Self; 5] =
        [Self::None, Self::Popc, Self::TwoPort, Self::Compensated, Self::Waves];

    /// The name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Popc => "popc-at-each-end",
            Self::TwoPort => "two-port-popc",
            Self::Compensated => "drift-compensated",
            Self::Waves => "wave-variables",
        }
    }
}
