//! Settings of POPC and LOLC.

use std::fmt;

use crate::files::scene::{Draft, Ledger, Stabilizer, Work};
use crate::text::{counted, found};

/// The settings of POPC and LOLC on a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// The work that they book.
    pub work: Work,
    /// The ledger that they sum energies in.
    pub ledger: Ledger,
    /// The limit of their damping, as a multiple of m / T.
    pub damping_cap: f64,
    /// The delay that sets that limit, in servo ticks; none where the scene writes it, or has no delay.
    pub delayed: Option<u32>,
    /// Whether the scene sets them; else they are the defaults.
    pub from_scene: bool,
}

impl Settings {
    /// The settings of the stabilizer that `scene` names, as far as it has them, and the defaults.
    pub fn of(scene: &Draft) -> Self {
        let (work, ledger) = match scene.stabilizer {
            Some(Stabilizer::Popc(popc)) => (popc.work, popc.ledger),
            Some(Stabilizer::Lolc(lolc)) => (lolc.work, lolc.ledger),
            _ => (Work::default(), Ledger::default()),
        };
        let observes = matches!(scene.stabilizer, Some(Stabilizer::Popc(_) | Stabilizer::Lolc(_)));
        let cap = scene.written_cap();
        Self {
            work,
            ledger,
            damping_cap: scene.damping_cap(),
            delayed: Some(scene.delay_ticks()).filter(|ticks| cap.is_none() && *ticks > 0),
            from_scene: observes || cap.is_some(),
        }
    }

    /// The kind of work in one word.
    pub(crate) fn work_name(&self) -> &'static str {
        self.work.name()
    }
}

impl fmt::Display for Settings {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (work, cap) = (self.work_name(), self.damping_cap);
        let source = if self.from_scene { "as the scene says" } else { "the defaults" };
        match self.delayed {
            None => write!(f, "{work} work, cap {cap} ({source})"),
            Some(ticks) => {
                let ticks = counted(ticks as usize, "tick");
                write!(f, "{work} work, cap {} ({source}, with {ticks} of delay)", found(cap))
            }
        }
    }
}
