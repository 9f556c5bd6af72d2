//! Answer in place of a missing one.

/// The answer of a port that has no new one: of a [`Guard`](crate::Guard) that rejects a sample, or a
/// [`Dropout`](crate::Dropout) that loses an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fallback {
    /// The last effort, 0 before the first.
    Hold,
    /// No effort.
    Zero,
}
