//! Answer in place of a missing one.

use lyapunov_core::Signal;

/// The answer of a port that has no new one: of a [`Guard`](crate::Guard) that rejects a sample, or a
/// [`Dropout`](crate::Dropout) that loses an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fallback {
    /// The last effort, 0 before the first.
    Hold,
    /// No effort.
    Zero,
}

impl Fallback {
    /// The answer where `last` was the one before.
    #[inline(always)]
    pub(crate) fn after<V: Signal>(self, last: V) -> V {
        match self {
            Self::Hold => last,
            Self::Zero => V::zero(),
        }
    }
}
