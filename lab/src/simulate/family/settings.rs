//! Settings of POPC and LOLC.

use std::fmt;

use crate::files::scene::{self, Cap, Draft, Ledger, Work};

/// The settings of POPC and LOLC on a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// The work that they book.
    pub work: Work,
    /// The ledger that they sum energies in.
    pub ledger: Ledger,
    /// The limit of their damping, as a multiple of m / T.
    pub damping_cap: Cap,
    /// Whether the scene sets them; else they are the defaults.
    pub from_scene: bool,
}

impl Settings {
    /// The settings of the stabilizer that `scene` names, whichever it is, or the defaults.
    pub fn of(scene: &Draft) -> Self {
        let (work, ledger, damping_cap) = match scene.stabilizer {
            None => (Work::default(), Ledger::default(), Cap::default()),
            Some(scene::Stabilizer::Popc(popc)) => (popc.work, popc.ledger, popc.damping_cap),
            Some(scene::Stabilizer::Lolc(lolc)) => (lolc.work, lolc.ledger, lolc.damping_cap),
        };
        Self { work, ledger, damping_cap, from_scene: scene.stabilizer.is_some() }
    }

    /// The kind of work in one word.
    pub(crate) fn work_name(&self) -> &'static str {
        match self.work {
            Work::Held => "held",
            Work::Sampled => "sampled",
        }
    }
}

impl fmt::Display for Settings {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (work, cap) = (self.work_name(), self.damping_cap.get());
        let source = if self.from_scene { "as the scene says" } else { "the defaults" };
        write!(f, "{work} work, cap {cap} ({source})")
    }
}
