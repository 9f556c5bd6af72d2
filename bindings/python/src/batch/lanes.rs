//! Signals on lanes: eight loops in one number.

use lyapunov::{Mask, Scalar, Signal};
use lyapunov_lab::F64x8;
use nalgebra::SVector;

/// The number of loops in a group.
pub(super) const LANES: usize = F64x8::LANES;

/// Signal of eight loops.
pub(super) trait Lanes: Signal<Scalar = F64x8> + Send + Sync {
    /// The number of axes.
    const COUNT: usize;

    /// The signals of `count` loops in `numbers`, one loop after the other; further lanes hold the last one.
    fn gather(numbers: &[f64], count: usize) -> Self;

    /// Writes the signals of the first lanes, as many as there is room for.
    fn scatter(self, numbers: &mut [f64]);
}

impl Lanes for F64x8 {
    const COUNT: usize = 1;

    #[inline(always)]
    fn gather(numbers: &[f64], count: usize) -> Self {
        match numbers.first_chunk::<LANES>() {
            Some(whole) => Self::from_reals(|lane| whole[lane]),
            None => Self::from_reals(|lane| numbers[lane.min(count - 1)]),
        }
    }

    #[inline(always)]
    fn scatter(self, numbers: &mut [f64]) {
        match numbers.first_chunk_mut::<LANES>() {
            Some(whole) => *whole = std::array::from_fn(|lane| self.real(lane)),
            None => {
                numbers.iter_mut().enumerate().for_each(|(lane, number)| *number = self.real(lane))
            }
        }
    }
}

impl<const N: usize> Lanes for SVector<F64x8, N> {
    const COUNT: usize = N;

    #[inline(always)]
    fn gather(numbers: &[f64], count: usize) -> Self {
        Self::from_fn(|axis, _| F64x8::from_reals(|lane| numbers[lane.min(count - 1) * N + axis]))
    }

    #[inline(always)]
    fn scatter(self, numbers: &mut [f64]) {
        for (lane, signal) in numbers.chunks_exact_mut(N).enumerate() {
            for (number, axis) in signal.iter_mut().zip(&self) {
                *number = axis.real(lane);
            }
        }
    }
}

/// Writes the lanes of a mask.
#[inline(always)]
pub(super) fn write_mask(mask: <F64x8 as Scalar>::Mask, truths: &mut [bool]) {
    for (lane, truth) in truths.iter_mut().enumerate() {
        *truth = mask.lane(lane);
    }
}
