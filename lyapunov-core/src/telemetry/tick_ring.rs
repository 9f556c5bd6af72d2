//! Ring of the last ticks.

use super::Csv;
use crate::{Correction, PortSample, Signal};

/// Recorded tick: what came in, and what the stabilizer made of it.
///
/// ```
/// use lyapunov_core::telemetry::TickRing;
/// use lyapunov_core::{Correction, HeldTick, Observer, PortEnergy};
/// let mut ring = TickRing::<f64, 16>::new();
/// for applied in [0.0, 2.0, -3.0] {
///     let tick = HeldTick { period: 1e-3, position: 0.0, velocity: 0.25, displacement: 0.25, applied };
///     ring.push(&tick.sample(), &Correction::none(1.0));
/// }
/// // The same motion under another observer.
/// let mut observer = Observer::of(PortEnergy);
/// let sums = ring.iter().map(|tick| observer.observe(&tick.sample, tick.correction.effort));
/// assert!(sums.eq([0.0, 0.5, -0.25]));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "PortSample<V>: serde::Serialize, Correction<V>: serde::Serialize",
        deserialize = "PortSample<V>: serde::Deserialize<'de>, Correction<V>: serde::Deserialize<'de>"
    ))
)]
pub struct RecordedTick<V: Signal> {
    /// The sample of the tick.
    pub sample: PortSample<V>,
    /// The correction that answered it.
    pub correction: Correction<V>,
}

/// Ring of the last `N` ticks of a loop, without an allocator: the oldest tick makes room for the newest.
///
/// A tick of one axis takes ten numbers and a mark, 44 bytes in `f32`: a second at 1 kHz is 44 kB. Record from the
/// start and read out when something happened; [`csv`](Self::csv) writes what `lyapunov observe` reads, and
/// [`iter`](Self::iter) gives whole ticks, to feed another stabilizer with the same motion.
///
/// ```
/// use lyapunov_core::telemetry::TickRing;
/// use lyapunov_core::{Correction, PortSample};
/// let mut ring = TickRing::<f32, 3>::new();
/// for tick in 0..5 {
///     ring.push(&PortSample::starting(1e-3, tick as f32, 0.0), &Correction::none(0.0));
/// }
/// let positions: [f32; 3] = core::array::from_fn(|index| ring.iter().nth(index).unwrap().sample.position);
/// assert_eq!((ring.seen(), ring.len(), positions), (5, 3, [2.0, 3.0, 4.0]));
/// # assert_eq!(size_of::<lyapunov_core::telemetry::RecordedTick<f32>>(), 44);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TickRing<V: Signal, const N: usize> {
    ticks: [Option<RecordedTick<V>>; N],
    next: usize,
    seen: u64,
}

impl<V: Signal, const N: usize> TickRing<V, N> {
    /// An empty ring, also for a `static`.
    pub const fn new() -> Self {
        Self { ticks: [None; N], next: 0, seen: 0 }
    }

    /// Records a tick.
    #[inline]
    pub fn push(&mut self, sample: &PortSample<V>, correction: &Correction<V>) {
        if let Some(oldest) = self.ticks.get_mut(self.next) {
            *oldest = Some(RecordedTick { sample: *sample, correction: *correction });
        }
        self.next = if self.next + 1 < N { self.next + 1 } else { 0 };
        self.seen = self.seen.wrapping_add(1);
    }

    /// The ticks that it holds, oldest first.
    pub fn iter(&self) -> impl Iterator<Item = &RecordedTick<V>> {
        let (newer, older) = self.ticks.split_at(self.next);
        older.iter().chain(newer).flatten()
    }

    /// Number of ticks that it holds: `N` once it is full.
    pub fn len(&self) -> usize {
        usize::try_from(self.seen).map_or(N, |seen| seen.min(N))
    }

    /// Whether it holds no tick.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Number of ticks recorded since the start, those that were overwritten included.
    pub fn seen(&self) -> u64 {
        self.seen
    }

    /// Forgets all ticks.
    pub fn clear(&mut self) {
        *self = Self::new();
    }

    /// The ticks that it holds as comma-separated values, to print or to write to a serial line.
    pub fn csv(&self) -> Csv<'_, V, N> {
        Csv::of(self)
    }
}

impl<V: Signal, const N: usize> Default for TickRing<V, N> {
    fn default() -> Self {
        Self::new()
    }
}

/// Ticks of one axis and of six can be logged: `nalgebra` formats its vectors only with a feature of its own.
#[cfg(feature = "defmt")]
const _: () = {
    const fn formats<T: defmt::Format>() {}
    formats::<RecordedTick<f32>>();
    formats::<RecordedTick<nalgebra::Vector6<f64>>>();
};
