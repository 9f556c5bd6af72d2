//! Entrants of a teleoperator's comparison.

use crate::text::names::Named;

/// Stabilizer of a teleoperator's link.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Entrant {
    /// No stabilizer: `none`.
    None,
    /// A passivity observer/controller at each port, which knows nothing of the other: `popc-at-each-end`.
    Popc,
    /// The two-port passivity controller, each end of which may spend what the other reports as absorbed:
    /// `two-port-popc`.
    TwoPort,
    /// The same, taking back the drift of the slave: `drift-compensated`.
    Compensated,
    /// The two-layer architecture, whose forces are limited by tanks that the master's damper fills: `two-layer`.
    TwoLayer,
    /// Wave variables before the slave's own controller: `wave-variables`.
    Waves,
    /// Wave variables, and a slave whose damper is their impedance: `wave-variables-matched`.
    MatchedWaves,
    /// The same, with a wave filter each way: `wave-variables-filtered`.
    FilteredWaves,
}

impl Entrant {
    /// Whether its account ends at the commanded port; that of the two-layer architecture ends at the slave's motion.
    pub(crate) fn is_held_to_the_command(self) -> bool {
        self != Self::TwoLayer
    }

    /// Whether it sends waves, which have an impedance.
    pub(crate) fn sends_waves(self) -> bool {
        matches!(self, Self::Waves | Self::MatchedWaves | Self::FilteredWaves)
    }
}

impl Named for Entrant {
    const KIND: &'static str = "a teleoperator";

    const ALL: &'static [Self] = &[
        Self::None,
        Self::Popc,
        Self::TwoPort,
        Self::Compensated,
        Self::TwoLayer,
        Self::Waves,
        Self::MatchedWaves,
        Self::FilteredWaves,
    ];

    fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Popc => "popc-at-each-end",
            Self::TwoPort => "two-port-popc",
            Self::Compensated => "drift-compensated",
            Self::TwoLayer => "two-layer",
            Self::Waves => "wave-variables",
            Self::MatchedWaves => "wave-variables-matched",
            Self::FilteredWaves => "wave-variables-filtered",
        }
    }
}
