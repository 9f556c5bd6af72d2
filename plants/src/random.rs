//! Random numbers that are the same on every machine.

use core::f64::consts::TAU;

use lyapunov_core::{ParameterError, Scalar, Signal, Snapshot};

/// A user of random numbers. Each has a stream of its own, so one seed serves all of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// Noise on a measured position.
    Noise = 1,
    /// Jitter of the sampling instants.
    Jitter = 2,
    /// Lost answers of an environment.
    Dropout = 3,
    /// Lost messages of a channel.
    Loss = 4,
    /// Delay of a channel for a message.
    Lag = 5,
    /// Numbers that differ among the members of an ensemble.
    Ensemble = 6,
}

/// Random numbers, independent in every call, axis and lane, from a seed for each lane.
///
/// The generator is Philox4x32-10: a bijection of a counter of 128 bits under a key of 64 bits (Salmon, Moraes, Dror
/// and Shaw, Parallel random numbers: as easy as 1, 2, 3, SC 2011). The seed is the key, and call, [`Source`] and axis
/// are the counter, so no number is drawn twice under one seed, and a lane with seed `s` draws the same numbers as a
/// scalar run with seed `s`. `docs/effects/noise.md` documents it in full. Numbers are computed in `f64` and rounded to
/// the scalar.
///
/// ```
/// use lyapunov_plants::{Random, Source};
/// let mut jitter = Random::new(|_| 7, Source::Jitter);
/// let (first, second): (f64, f64) = (jitter.normal(), jitter.normal());
/// assert!(first != second);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Random<T> {
    /// The seed of each lane in parts of 16 bits, least significant first: a lane holds 16 bits exactly, but not a
    /// `u64`.
    seeds: [T; 4],
    /// Whether all lanes have one seed, and thus the same numbers.
    is_one: bool,
    source: Source,
    calls: u64,
}

impl<T: Scalar> Random<T> {
    /// Random numbers of which lane `i` draws from `seed(i)`; a scalar is lane 0.
    pub fn new(seed: impl Fn(usize) -> u64, source: Source) -> Self {
        let part =
            |index: usize| T::from_lanes(|lane| f64::from((seed(lane) >> (16 * index)) as u16));
        let is_one = (0..T::LANES).all(|lane| seed(lane) == seed(0));
        Self { seeds: core::array::from_fn(part), is_one, source, calls: 0 }
    }

    /// The same numbers from call `calls` on, counted from 0.
    ///
    /// ```
    /// use lyapunov_plants::{Random, Source};
    /// let mut drawn = Random::<f64>::new(|_| 7, Source::Ensemble);
    /// let numbers: [f64; 3] = core::array::from_fn(|_| drawn.uniform());
    /// assert_eq!(Random::<f64>::new(|_| 7, Source::Ensemble).from_call(2).uniform(), numbers[2]);
    /// ```
    #[must_use]
    pub fn from_call(self, calls: u64) -> Self {
        Self { calls, ..self }
    }

    /// The next number of the standard normal distribution, on every axis.
    #[inline]
    pub fn normal<V: Signal<Scalar = T>>(&mut self) -> V {
        let mut axis = 0;
        let drawn = V::zero().map(|_| {
            let axes = self.drawn(axis, gaussian);
            axis += 1;
            axes
        });
        self.calls = self.calls.wrapping_add(1);
        drawn
    }

    /// The next uniform number, in `[0, 1)` before it is rounded to the scalar.
    #[inline]
    pub fn uniform(&mut self) -> T {
        let drawn = self.drawn(0, |[high, low, ..]| uniform(high, low));
        self.calls = self.calls.wrapping_add(1);
        drawn
    }

    /// The lanes in which an event of the given probability happens: none at 0, all at 1.
    #[inline]
    pub fn chance(&mut self, probability: T) -> T::Mask {
        let number = |lane: usize| {
            let [high, low, ..] = self.words(0, lane);
            uniform(high, low)
        };
        let first = number(0);
        let happens = T::from_lanes(|lane| {
            let drawn = if self.is_one { first } else { number(lane) };
            // Compared in f64: rounded to the scalar, the number might become 1.
            f64::from(u8::from(drawn < probability.lane(lane)))
        });
        self.calls = self.calls.wrapping_add(1);
        happens.above(T::zero())
    }

    /// The number that `of` makes of each lane's random bits.
    fn drawn(&self, axis: u32, of: impl Fn([u32; 4]) -> f64) -> T {
        if self.is_one {
            T::of(of(self.words(axis, 0)))
        } else {
            T::from_lanes(|lane| of(self.words(axis, lane)))
        }
    }

    /// The four words of this call.
    fn words(&self, axis: u32, lane: usize) -> [u32; 4] {
        let [a, b, c, d] = core::array::from_fn(|part| self.seeds[part].lane(lane) as u32);
        let counter = [self.calls as u32, (self.calls >> 32) as u32, self.source as u32, axis];
        philox(counter, [a | b << 16, c | d << 16])
    }
}

impl<T: Scalar> Snapshot for Random<T> {
    /// The number of calls.
    type State = u64;

    fn state(&self) -> u64 {
        self.calls
    }

    fn restored(self, calls: u64) -> Result<Self, ParameterError> {
        Ok(self.from_call(calls))
    }
}

/// Philox4x32-10.
fn philox(mut counter: [u32; 4], mut key: [u32; 2]) -> [u32; 4] {
    let product = |a: u32, b: u32| {
        let product = u64::from(a) * u64::from(b);
        ((product >> 32) as u32, product as u32)
    };
    for _ in 0..10 {
        let [a, b, c, d] = counter;
        let (high, low) = product(0xd251_1f53, a);
        let (other_high, other_low) = product(0xcd9e_8d57, c);
        counter = [other_high ^ b ^ key[0], other_low, high ^ d ^ key[1], low];
        key = [key[0].wrapping_add(0x9e37_79b9), key[1].wrapping_add(0xbb67_ae85)];
    }
    counter
}

/// A number in `[0, 1)`: the upper 53 of 64 bits.
fn uniform(high: u32, low: u32) -> f64 {
    let bits = u64::from(high) << 32 | u64::from(low);
    (bits >> 11) as f64 / (1u64 << 53) as f64
}

/// A normal number from two uniform ones (Box and Muller, A note on the generation of random normal deviates, 1958):
/// only the cosine of the pair, so that every call costs the same.
fn gaussian([a, b, c, d]: [u32; 4]) -> f64 {
    let radius = libm::sqrt(-2.0 * libm::log(1.0 - uniform(a, b)));
    radius * libm::cos(TAU * uniform(c, d))
}

#[cfg(test)]
mod tests {
    use super::philox;

    /// The known answers that the authors publish with their library Random123 (`tests/kat_vectors`).
    #[test]
    fn philox_gives_the_published_answers() {
        let pi = [0x243f_6a88, 0x85a3_08d3, 0x1319_8a2e, 0x0370_7344];
        for (counter, key, expected) in [
            ([0; 4], [0; 2], [0x6627_e8d5, 0xe169_c58d, 0xbc57_ac4c, 0x9b00_dbd8]),
            ([!0; 4], [!0; 2], [0x408f_276d, 0x41c8_3b0e, 0xa20b_c7c6, 0x6d54_51fd]),
            (pi, [0xa409_3822, 0x299f_31d0], [0xd16c_fe09, 0x94fd_cceb, 0x5001_e420, 0x2412_6ea1]),
        ] {
            assert_eq!(philox(counter, key), expected);
        }
    }
}
