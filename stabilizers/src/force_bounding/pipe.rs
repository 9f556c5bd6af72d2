//! Pipe of forces under way: energy that is committed and does not act yet.

use core::mem::swap;

use lyapunov_core::{ParameterError, Requirement, Scalar};
use nalgebra::SVector;

/// The energy that each force under way may take at most, J, the latest first; without room for one it has no size.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pipe<T, const N: usize> {
    slots: [Slot<T>; N],
}

/// Place in the pipe, which a delay shorter than its capacity leaves out.
#[derive(Clone, Copy, Debug)]
struct Slot<T> {
    cost: T,
    used: bool,
}

impl<T: Scalar, const N: usize> Pipe<T, N> {
    /// A pipe of `ticks` periods.
    pub(super) fn new(ticks: u32) -> Result<Self, ParameterError> {
        Requirement::AtMost(N as f64).check("delay ticks", f64::from(ticks))?;
        let mut slots = [Slot { cost: T::of(0.0), used: false }; N];
        slots.iter_mut().take(ticks as usize).for_each(|slot| slot.used = true);
        Ok(Self { slots })
    }

    /// What each of them may take, J.
    pub(super) fn costs(&self) -> SVector<T, N> {
        SVector::from_fn(|index, _| self.slots[index].cost)
    }

    /// The same pipe with other forces under way; nothing is in the places that are left out.
    pub(super) fn carrying(mut self, costs: SVector<T, N>) -> Result<Self, ParameterError> {
        for (slot, cost) in self.slots.iter_mut().zip(costs.iter()) {
            let cost = Requirement::NonNegative.check("stored cost", *cost)?;
            slot.cost = if slot.used { cost } else { T::of(0.0) };
        }
        Ok(self)
    }

    /// Energy that all of them may take.
    #[inline(always)]
    pub(super) fn committed(&self) -> T {
        self.slots.iter().fold(T::of(0.0), |sum, slot| sum + slot.cost)
    }

    /// Puts `cost` behind the others; the oldest leaves, as its force acts from now on.
    #[inline(always)]
    pub(super) fn push(&mut self, mut cost: T) {
        for slot in self.slots.iter_mut().filter(|slot| slot.used) {
            swap(&mut slot.cost, &mut cost);
        }
    }
}
