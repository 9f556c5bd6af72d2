//! Test samples for the laws.

use crate::{HeldTick, PortSample, Scalar, Signal};

/// Number of samples.
const COUNT: usize = 2000;

/// Motions and efforts of many sizes: strokes to and fro, rests, and forces for and against them.
///
/// They are the same on every machine: the numbers come from splitmix64 (Steele, Lea and Flood, OOPSLA 2014).
///
/// ```
/// use lyapunov_core::laws::Samples;
/// let drive: Vec<_> = Samples::<f64>::new(1e-3).collect();
/// assert_eq!(drive.len(), 2000);
/// assert!(drive.iter().any(|(sample, _)| sample.velocity == 0.0)); // some rest
/// let other: Vec<_> = Samples::<f64>::new(1e-3).seeded(7).collect();
/// assert_ne!(drive, other);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Samples<V: Signal> {
    period: V::Scalar,
    position: V,
    applied: V,
    tick: usize,
    seed: u64,
}

impl<V: Signal> Samples<V> {
    /// Samples of a loop with this `period`, s.
    pub fn new(period: V::Scalar) -> Self {
        Self { period, position: V::zero(), applied: V::zero(), tick: 0, seed: 1 }
    }

    /// The same kind of samples with other numbers.
    #[must_use]
    pub fn seeded(self, seed: u64) -> Self {
        Self { seed, ..self }
    }

    /// Uniform in [-1, 1).
    fn draw(&mut self) -> f64 {
        self.seed = self.seed.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut bits = self.seed;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((bits ^ (bits >> 31)) >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn signal(&mut self, size: f64) -> V {
        V::zero().map(|_| V::Scalar::from_lanes(|_| size * self.draw()))
    }
}

impl<V: Signal> Iterator for Samples<V> {
    type Item = (PortSample<V>, V);

    fn next(&mut self) -> Option<Self::Item> {
        if self.tick == COUNT {
            return None;
        }
        // A hundred samples of one size: velocities from 1e-6 to 1e2 m/s, efforts from 1e-4 to 1e4 N.
        let size = [1e-6, 1.0, 1e-3, 1e2, 1e-1][self.tick / 100 % 5];
        let resting = self.tick % 11 == 10;
        let velocity = if resting { V::zero() } else { self.signal(size) };
        let displacement = velocity.scale(self.period);
        self.position = self.position + displacement;
        let sample = HeldTick {
            period: self.period,
            position: self.position,
            velocity,
            displacement,
            applied: self.applied,
        }
        .sample();
        let effort = self.signal(1e2 * size);
        self.applied = effort;
        self.tick += 1;
        Some((sample, effort))
    }
}
