//! Plant: the side of a port that moves.

use crate::{PortSample, Signal};

/// Plant: the side of the port that moves under the applied effort.
///
/// The loop is two calls:
///
/// ```
/// use lyapunov_core::{OnePort, Plant, Signal};
/// fn run<V: Signal>(plant: &mut impl Plant<V>, port: &mut impl OnePort<V>, ticks: usize) {
///     let mut sample = plant.start();
///     for _ in 0..ticks {
///         sample = plant.advance(port.respond(&sample));
///     }
/// }
/// ```
pub trait Plant<V: Signal> {
    /// The sample of the first tick: where the plant stands, with nothing moved and nothing applied yet.
    fn start(&self) -> PortSample<V>;

    /// Moves for one period under the held `effort`, and returns the sample.
    ///
    /// The effort is what the environment exerts against the plant: a positive one accelerates it
    /// backwards, `m ẍ = … − effort`.
    fn advance(&mut self, effort: V) -> PortSample<V>;

    /// As [`advance`](Self::advance), but writes the sample in place.
    ///
    /// It is for plants behind a table of methods (`Box<dyn Plant<V>>`). A sample that is returned from there is
    /// written number by number and then copied by pairs of numbers; such a read waits until the writes before it are
    /// done, and the processor does not begin the next tick meanwhile. References and boxes of a plant forward this call.
    #[inline(always)]
    fn advance_into(&mut self, effort: V, sample: &mut PortSample<V>) {
        // Field by field: lanes written a pair at a time and then copied by wider reads would wait as well.
        let moved = self.advance(effort);
        sample.period = moved.period;
        sample.position = moved.position;
        sample.velocity = moved.velocity;
        sample.displacement = moved.displacement;
        sample.applied = moved.applied;
        sample.work = moved.work;
    }
}

impl<V: Signal, P: Plant<V> + ?Sized> Plant<V> for &mut P {
    #[inline]
    fn start(&self) -> PortSample<V> {
        (**self).start()
    }

    #[inline]
    fn advance(&mut self, effort: V) -> PortSample<V> {
        (**self).advance(effort)
    }

    #[inline]
    fn advance_into(&mut self, effort: V, sample: &mut PortSample<V>) {
        (**self).advance_into(effort, sample);
    }
}
