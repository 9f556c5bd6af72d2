//! Units of a random loop.

use super::draw::Draw;

/// Units that a loop is drawn in, so that most loops are neither trivial nor hopeless: a tick, a mass and a length.
#[derive(Clone, Copy, Debug)]
pub(super) struct Size {
    /// The servo rate, Hz.
    pub(super) rate: f64,
    /// The mass that moves, kg.
    pub(super) mass: f64,
    /// The length of motions, m.
    pub(super) length: f64,
}

impl Size {
    /// Rates from 0.01 Hz to 30 kHz, masses over eight decades, lengths from 0.1 µm to 10 m.
    pub(super) fn drawn(draw: &mut Draw) -> Self {
        Self {
            rate: draw.decades(-2.0, 4.5),
            mass: draw.decades(-4.0, 4.0),
            length: draw.decades(-7.0, 1.0),
        }
    }

    /// s.
    pub(super) fn period(&self) -> f64 {
        self.rate.recip()
    }

    /// `m / T²`, N/m.
    pub(super) fn stiffness(&self) -> f64 {
        self.mass * self.rate * self.rate
    }

    /// `m / T`, N·s/m.
    pub(super) fn damping(&self) -> f64 {
        self.mass * self.rate
    }

    /// The force of the stiffness on the length, N.
    pub(super) fn force(&self) -> f64 {
        self.stiffness() * self.length
    }
}
