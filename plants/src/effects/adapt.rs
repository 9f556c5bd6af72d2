//! Chaining: what acts on a port owns it.

use lyapunov_core::{OnePort, ParameterError, Signal};

use crate::{Delay, Difference, Encoder, Fallback, Guard, Hold, Saturation};

/// What may act on a port, chained like iterator adaptors, innermost first.
///
/// Efforts pass outwards and drives inwards, so order means something: `wall.held(10)?.stabilized(c)` watches
/// at the servo rate, `wall.stabilized(c).held(10)?` only at the environment's. What measures stands outermost:
/// `port.differenced().encoded(1e-5)?` takes velocities from the encoder's counts.
pub trait Adapt<V: Signal>: OnePort<V> + Sized {
    /// Asks this port on every `ticks`-th call only and holds its effort in between.
    ///
    /// # Errors
    /// `ticks` is 0.
    fn held(self, ticks: u32) -> Result<Hold<Self, V>, ParameterError> {
        Hold::new(self, ticks)
    }

    /// Clips the effort to `±force` on each axis, N.
    ///
    /// # Errors
    /// `force` not above 0 and finite.
    fn saturated(self, force: V::Scalar) -> Result<Saturation<Self, V::Scalar>, ParameterError> {
        Saturation::new(self, force)
    }

    /// Lets the effort act `ticks` calls late; `N` is the room for them.
    ///
    /// # Errors
    /// `ticks` is above `N`.
    fn delayed<const N: usize>(self, ticks: usize) -> Result<Delay<Self, V, N>, ParameterError> {
        Delay::new(self, ticks)
    }

    /// Rounds positions to an encoder's `resolution`, m.
    ///
    /// # Errors
    /// `resolution` not above 0 and finite.
    fn encoded(self, resolution: V::Scalar) -> Result<Encoder<Self, V>, ParameterError> {
        Encoder::new(self, resolution)
    }

    /// Takes velocities from displacements.
    fn differenced(self) -> Difference<Self> {
        Difference::new(self)
    }

    /// Turns away samples that are not finite before anything inside is touched.
    fn guarded(self, fallback: Fallback) -> Guard<Self, V> {
        Guard::new(self, fallback)
    }
}

impl<V: Signal, P: OnePort<V>> Adapt<V> for P {}
