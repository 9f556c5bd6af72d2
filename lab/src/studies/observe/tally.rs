//! Tally of the energy into a port and out of it.

use lyapunov::accumulators::{Accumulator, Compensated};

/// Energy into a port and out of it, and the motion meanwhile.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tally {
    into: Compensated<f64>,
    out: Compensated<f64>,
    motion: Compensated<f64>,
}

impl Tally {
    pub(super) fn new() -> Self {
        let zero = Compensated::zero();
        Self { into: zero, out: zero, motion: zero }
    }

    /// Adds a step that did `work` joules at `motion = v² T`.
    pub(super) fn add(&mut self, work: f64, motion: f64) {
        if work >= 0.0 {
            self.into.add(work);
        } else {
            self.out.add(-work);
        }
        self.motion.add(motion);
    }

    pub(super) fn add_all(&mut self, other: &Self) {
        self.into.add(other.into.value());
        self.out.add(other.out.value());
        self.motion.add(other.motion.value());
    }

    /// Sum of the positive works, J.
    pub(super) fn absorbed(&self) -> f64 {
        self.into.value()
    }

    /// Sum of the negative works without their sign, J.
    pub(super) fn released(&self) -> f64 {
        self.out.value()
    }

    /// Energy released minus energy absorbed, J.
    pub(super) fn generated(&self) -> f64 {
        self.out.value() - self.into.value()
    }

    /// `Σ v² T`, m²/s.
    pub(super) fn motion(&self) -> f64 {
        self.motion.value()
    }

    /// The constant damper that dissipates `debt` joules over the motion, N·s/m; none where nothing moved.
    pub(super) fn damper(&self, debt: f64) -> Option<f64> {
        if debt <= 0.0 {
            return Some(0.0);
        }
        Some(debt / self.motion()).filter(|damping| damping.is_finite())
    }
}
