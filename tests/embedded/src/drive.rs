//! Ticks that drive a member: the samples of the laws, some of them spoilt.

use core::ops::Range;

use lyapunov_core::laws::Samples;
use lyapunov_core::{PortSample, Scalar, Signal};

/// Ticks from one seed.
pub const BLOCK: usize = 2000;

/// Seeds of the blocks: five blocks are 10,000 ticks.
pub const SEEDS: Range<u64> = 1..6;

/// One tick in this many is spoilt.
const SPOILT: usize = 7;

/// The last two ticks of this many are free motion: nothing is asked, and nothing acts.
const FREE: usize = 13;

/// Samples and efforts of every size, some of free motion, one in seven spoilt: not finite, subnormal, as large as can be, or over
/// no time.
///
/// Numbers as large as can be come in the last block only, since a sum that took one in sees nothing small any more.
pub struct Ticks<V: Signal> {
    samples: Samples<V>,
    tick: usize,
    last: bool,
    was_free: bool,
}

impl<V: Signal> Ticks<V> {
    /// The ticks of a `seed`.
    pub fn new(seed: u64) -> Self {
        let period = V::Scalar::of(1e-3);
        let samples = Samples::new(period).seeded(seed);
        Self { samples, tick: 0, last: seed + 1 == SEEDS.end, was_free: false }
    }

    /// Number `kind` of the unusual numbers.
    fn unusual(&self, kind: usize) -> V::Scalar {
        let least = V::Scalar::smallest_positive();
        match kind % 6 {
            0 => V::Scalar::of(f64::NAN),
            1 => V::Scalar::of(f64::INFINITY),
            2 => V::Scalar::of(f64::NEG_INFINITY),
            3 => least,
            4 => -(least + least),
            _ if self.last => V::Scalar::largest(),
            _ => -V::Scalar::smallest_normal(),
        }
    }
}

impl<V: Signal> Iterator for Ticks<V> {
    type Item = (PortSample<V>, V);

    // Outside of the members' code, which is many times there.
    #[inline(never)]
    fn next(&mut self) -> Option<Self::Item> {
        let (mut sample, mut effort) = self.samples.next()?;
        if self.was_free {
            (sample.applied, sample.work) = (V::zero(), V::zero());
        }
        self.was_free = self.tick % FREE >= FREE - 2;
        if self.was_free {
            effort = V::zero();
        }
        let kind = self.tick / SPOILT;
        if self.tick % SPOILT == SPOILT - 1 {
            let bad = self.unusual(kind);
            let spoilt = V::splat(bad);
            match kind / 6 % 7 {
                0 => sample.period = bad,
                1 => sample.position = spoilt,
                2 => sample.velocity = spoilt,
                3 => sample.displacement = spoilt,
                4 => sample.applied = spoilt,
                5 => sample.work = spoilt,
                _ => effort = spoilt,
            }
        }
        self.tick += 1;
        Some((sample, effort))
    }
}
