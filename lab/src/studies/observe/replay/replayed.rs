//! What stabilizers would have done on a recorded motion.

use serde::Serialize;

use crate::show::envelope::Envelope;

/// What one stabilizer would have done on the recorded motion, in SI units.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Replayed {
    /// Its name.
    pub stabilizer: &'static str,
    /// The number of rows that it was told.
    pub ticks: u64,
    /// The number of rows on which it would have added a force other than 0.
    pub active_ticks: u64,
    /// Their share, %.
    pub active_percent: f64,
    /// Time of the first of them, s; none without one.
    pub first_at: Option<f64>,
    /// Largest magnitude of the force that it would have added, N.
    pub largest_force: f64,
    /// Time of the largest, s; none where it adds nothing.
    pub largest_force_at: Option<f64>,
    /// Root mean square of the force that it would have added, over all rows, N.
    pub rms_force: f64,
    /// Energy that this force would have taken out of the recorded motion, `Σ f Δx`, J; below 0 it would have given.
    pub energy_taken: f64,
    /// Largest debt that it could not serve on a tick, as it tells itself, J.
    pub shortfall: f64,
    /// Time of that tick, s; none without a shortfall.
    pub shortfall_at: Option<f64>,
    /// The most that the port gives beyond what it took, `max(0, −min Σ (f + f_added) Δx)`, J: what is left unrepaired,
    /// by the work and not by the stabilizer's own account.
    pub energy_given: f64,
    /// Rows that it would have rejected.
    pub rejected: u64,
}

impl Replayed {
    /// The row of a stabilizer before the first tick.
    pub(super) fn of(stabilizer: &'static str) -> Self {
        Self { stabilizer, ..Self::default() }
    }
}

/// Stabilizer that was named and cannot be replayed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Left {
    /// Its name.
    pub stabilizer: &'static str,
    /// The reason.
    pub reason: &'static str,
}

/// What stabilizers would have done on a log.
#[derive(Clone, Debug, Serialize)]
pub struct Replay {
    /// The scene that set their numbers.
    pub scene: String,
    /// What this says, and what not.
    pub note: &'static str,
    /// The stabilizers.
    pub stabilizers: Vec<Replayed>,
    /// Those that were named and cannot be replayed.
    pub not_replayed: Vec<Left>,
    #[serde(skip)]
    pub(super) traces: Vec<Envelope>,
}

impl PartialEq for Replay {
    fn eq(&self, other: &Self) -> bool {
        // The curves follow from the same log.
        self.scene == other.scene
            && self.stabilizers == other.stabilizers
            && self.not_replayed == other.not_replayed
    }
}
