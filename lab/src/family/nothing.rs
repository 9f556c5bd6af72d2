//! No stabilizer.

use lyapunov::{Action, Drive, Signal, Stabilizer};

/// No stabilizer: the effort goes through as it came.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Nothing;

impl<V: Signal> Stabilizer<V> for Nothing {
    #[inline]
    fn stabilize(&mut self, _drive: &Drive<V>, effort: V) -> Action<V> {
        Action::none(effort)
    }
}
