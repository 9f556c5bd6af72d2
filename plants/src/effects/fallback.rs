//! What is answered in place of an answer that is not there.

/// What a port answers when there is no new answer: a [`Guard`](crate::Guard) that turns a sample away, or a
/// [`Dropout`](crate::Dropout) that loses one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fallback {
    /// The last effort there was, 0 before the first.
    Hold,
    /// No effort.
    Zero,
}
