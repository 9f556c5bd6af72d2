//! What a port is driven by.

use crate::{Drive, Signal};

/// The other side of the port: what moves, and is moved by the effort that acts.
///
/// The loop is two calls:
///
/// ```
/// use lyapunov_core::{OnePort, Plant, Signal};
/// fn run<V: Signal>(plant: &mut impl Plant<V>, port: &mut impl OnePort<V>, ticks: usize) {
///     let mut drive = plant.start();
///     for _ in 0..ticks {
///         drive = plant.advance(port.respond(&drive));
///     }
/// }
/// ```
pub trait Plant<V: Signal> {
    /// The drive of the first tick: where the plant stands, with nothing moved and nothing acted yet.
    fn start(&self) -> Drive<V>;

    /// Moves for one period under `effort`, held, and tells what happened.
    ///
    /// The effort is what the environment exerts against the plant: a positive one accelerates it
    /// backwards, `m ẍ = … − effort`.
    fn advance(&mut self, effort: V) -> Drive<V>;

    /// As [`advance`](Self::advance), and writes in place what happened.
    ///
    /// It is for plants that are called through a table (`Box<dyn Plant<V>>`). A drive that is returned from there is
    /// written number by number and then copied by pairs of numbers; such a read waits until the writes before it are
    /// done, and the processor does not begin the next tick meanwhile. What owns a plant hands it on.
    #[inline]
    fn advance_into(&mut self, effort: V, drive: &mut Drive<V>) {
        // Field by field: lanes written a pair at a time and then copied by wider reads would wait as well.
        let moved = self.advance(effort);
        drive.period = moved.period;
        drive.position = moved.position;
        drive.velocity = moved.velocity;
        drive.displacement = moved.displacement;
        drive.acted = moved.acted;
        drive.work = moved.work;
    }
}

impl<V: Signal, P: Plant<V> + ?Sized> Plant<V> for &mut P {
    #[inline]
    fn start(&self) -> Drive<V> {
        (**self).start()
    }

    #[inline]
    fn advance(&mut self, effort: V) -> Drive<V> {
        (**self).advance(effort)
    }

    #[inline]
    fn advance_into(&mut self, effort: V, drive: &mut Drive<V>) {
        (**self).advance_into(effort, drive);
    }
}
