//! Constant delay of a channel.

use lyapunov_core::{ParameterError, Requirement};

use super::Channel;

/// A channel that delays every message by the same number of ticks; `N` is the capacity.
///
/// ```
/// use lyapunov_plants::{Channel, ConstantDelay};
/// let mut channel = ConstantDelay::<_, 4>::new(2, 0.0)?;
/// assert_eq!([1.0, 2.0, 3.0, 4.0].map(|message| channel.carry(message)), [0.0, 0.0, 1.0, 2.0]);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct ConstantDelay<M, const N: usize> {
    ticks: usize,
    next: usize,
    /// The last message that was not lost: over a constant delay it comes out again where a lost one would have.
    newest: M,
    waiting: [M; N],
}

impl<M: Copy, const N: usize> ConstantDelay<M, N> {
    /// A delay of `ticks`; until the first message arrives, the channel gives `before`.
    ///
    /// # Errors
    /// `ticks` is above `N`.
    pub fn new(ticks: u32, before: M) -> Result<Self, ParameterError> {
        Requirement::AtMost(N as f64).check("channel ticks", f64::from(ticks))?;
        Ok(Self { ticks: ticks as usize, next: 0, newest: before, waiting: [before; N] })
    }
}

impl<M: Copy, const N: usize> Channel<M> for ConstantDelay<M, N> {
    fn carry(&mut self, message: M) -> M {
        self.newest = message;
        let Some(slot) = self.waiting[..self.ticks].get_mut(self.next) else {
            return message;
        };
        let next = self.next + 1;
        self.next = if next == self.ticks { 0 } else { next };
        core::mem::replace(slot, message)
    }

    fn lose(&mut self) -> M {
        self.carry(self.newest)
    }
}
