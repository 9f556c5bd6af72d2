//! Random numbers to try, the same on every run.

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

    /// Uniform in `±size`.
    pub(crate) fn within(&mut self, size: f64) -> f64 {
        size * ((self.draw() >> 11) as f64 / (1u64 << 52) as f64 - 1.0)
    }
}
