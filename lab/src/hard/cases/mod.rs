//! The catalogue, by theme.

mod axes;
mod contact;
mod delay;
mod environment;
mod faults;
mod limit;
mod reading;
mod scale;
mod signals;
mod stiffness;
mod time;

use lyapunov::{Action, Drive, Signal, Stabilizer};

use super::case::Case;

/// No stabilizer.
#[derive(Clone, Copy, Debug)]
pub(super) struct Nothing;

impl<V: Signal> Stabilizer<V> for Nothing {
    fn stabilize(&mut self, _drive: &Drive<V>, effort: V) -> Action<V> {
        Action::none(effort)
    }
}

/// Every case, in the order in which they are told.
pub(super) fn all() -> Vec<Case> {
    [
        signals::cases(),
        faults::cases(),
        reading::cases(),
        time::cases(),
        stiffness::cases(),
        contact::cases(),
        delay::cases(),
        limit::cases(),
        environment::cases(),
        axes::cases(),
        scale::cases(),
    ]
    .into_iter()
    .flatten()
    .collect()
}
