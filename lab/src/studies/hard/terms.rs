//! The numbers and promises that a run is judged by.

use crate::files::scene::Pledge;

/// The numbers and promises that a run is judged by.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Terms {
    /// Ticks in all.
    pub(super) ticks: u64,
    /// The position that swings are measured from, m.
    pub(super) rest: f64,
    /// The damping limit, N·s/m.
    pub(super) limit: f64,
    /// The promises of the stabilizer.
    pub(super) pledge: Pledge,
    /// The largest force that may be applied, N.
    pub(super) force: f64,
    /// The cause of samples that are not finite.
    pub(super) unsound: Unsound,
}

/// Cause of a sample that is not finite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Unsound {
    /// A fault, after which the run goes on.
    Fault,
    /// A motion or a force beyond the range of the scalar: nothing else makes such a sample in the loop of a scene.
    Range,
}

impl Terms {
    /// Terms of a run under POPC in which nothing saturates.
    pub(super) fn of(ticks: u64, limit: f64) -> Self {
        Self {
            ticks,
            rest: 0.0,
            limit,
            pledge: Pledge::POPC,
            force: f64::INFINITY,
            unsound: Unsound::Fault,
        }
    }
}
