//! Hash of what a member answers.

use lyapunov_core::{Correction, Mask, PortSample, Scalar, Signal, Stabilizer};

use crate::{SEEDS, Ticks};

/// One step, as a function of its own whose instructions, stack and bytes can be told from the rest.
#[inline(never)]
#[cfg_attr(realtime, sanitize(realtime = "nonblocking"))]
pub fn step<V: Signal, S: Stabilizer<V>>(
    member: &mut S,
    sample: &PortSample<V>,
    effort: V,
) -> Correction<V> {
    member.stabilize(sample, effort)
}

/// Hash of numbers, bit by bit and in their order: a rotation, an exclusive or and a product for each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hash(pub u64);

impl Hash {
    /// The hash of nothing.
    pub const EMPTY: Self = Self(0xCBF2_9CE4_8422_2325);

    /// Adds `word`.
    pub fn add(&mut self, word: u64) {
        self.0 = (self.0.rotate_left(5) ^ word).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    }

    /// Adds `value`. Every NaN is the same: its sign and payload are not defined.
    fn number(&mut self, value: f64) {
        self.add(if value.is_nan() { u64::MAX } else { value.to_bits() });
    }

    /// Adds lane `lane` of what a member told.
    pub fn correction<V: Signal>(&mut self, told: &Correction<V>, lane: usize) {
        told.effort.map(|axis| {
            self.number(axis.lane(lane));
            axis
        });
        for energy in [told.observed_energy, told.alpha, told.shortfall] {
            self.number(energy.lane(lane));
        }
        self.add(u64::from(told.accepted.lane(lane)));
    }
}

/// Hash of lane `lane` over `ticks` ticks from each of the seeds, by a fresh `member` each time. `watch` is called in place of
/// [`step`], which it calls.
pub fn hash<V: Signal, S: Stabilizer<V> + Copy>(
    member: S,
    ticks: usize,
    lane: usize,
    mut watch: impl FnMut(&mut S, &PortSample<V>, V) -> Correction<V>,
) -> Hash {
    let mut hash = Hash::EMPTY;
    for seed in SEEDS {
        let mut fresh = member;
        for (sample, effort) in Ticks::new(seed).take(ticks) {
            hash.correction(&watch(&mut fresh, &sample, effort), lane);
        }
    }
    hash
}
