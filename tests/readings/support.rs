//! Numbers and readings to try.

use lyapunov::{Reading, Readings, Signal};

pub(crate) use crate::dice::Dice;

pub(crate) const PERIOD: f64 = 1.0 / 1024.0; // s: its multiples are exact

/// The memory of a port, read every [`PERIOD`].
pub(crate) fn readings<V: Signal<Scalar = f64>>() -> Readings<V> {
    Readings::every(PERIOD).expect("a period")
}

pub(crate) fn reading<V>(position: V, applied: V) -> Reading<V> {
    Reading { position, applied }
}

impl Dice {
    /// A whole number within `±most`.
    pub(crate) fn whole(&mut self, most: u64) -> f64 {
        (self.draw() % (2 * most + 1)) as f64 - most as f64
    }
}
