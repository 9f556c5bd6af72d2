//! Pipe of forces under way: energy that is committed and does not act yet.

use lyapunov_core::{ParameterError, Requirement, Scalar};

/// The energy that each force under way may take at most, J, in a ring of `N`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pipe<T, const N: usize> {
    costs: [T; N],
    ticks: usize,
    next: usize,
}

impl<T: Scalar, const N: usize> Pipe<T, N> {
    /// A pipe of `ticks` periods.
    pub(super) fn new(ticks: u32) -> Result<Self, ParameterError> {
        Requirement::AtMost(N as f64).check("delay ticks", f64::from(ticks))?;
        Ok(Self { costs: [T::of(0.0); N], ticks: ticks as usize, next: 0 })
    }

    /// Energy that all of them may take.
    #[inline(always)]
    pub(super) fn committed(&self) -> T {
        self.costs.iter().fold(T::of(0.0), |sum, cost| sum + *cost)
    }

    /// Puts `cost` in the place of the oldest, which acts from now on.
    #[inline(always)]
    pub(super) fn push(&mut self, cost: T) {
        if self.ticks > 0 {
            if let Some(oldest) = self.costs.get_mut(self.next) {
                *oldest = cost;
            }
            self.next = if self.next + 1 < self.ticks { self.next + 1 } else { 0 };
        }
    }
}
