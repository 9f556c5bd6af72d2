//! Numbers and readings to try.

use lyapunov::{Reading, Readings, Signal};

pub(crate) const PERIOD: f64 = 1.0 / 1024.0; // s: its multiples are exact

/// The memory of a port, read every [`PERIOD`].
pub(crate) fn readings<V: Signal<Scalar = f64>>() -> Readings<V> {
    Readings::every(PERIOD).expect("a period")
}

pub(crate) fn reading<V>(position: V, applied: V) -> Reading<V> {
    Reading { position, applied }
}

/// A generator of its own (Marsaglia, Xorshift RNGs, Journal of Statistical Software 8(14), 2003).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Dice(u64);

impl Dice {
    pub(crate) fn of(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    pub(crate) fn draw(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    /// A whole number within `±most`.
    pub(crate) fn whole(&mut self, most: u64) -> f64 {
        (self.draw() % (2 * most + 1)) as f64 - most as f64
    }
}
