//! Everything that stands at a port.

use crate::{Correction, PortSample, Signal, Stabilized, Stabilizer};

/// Something with one port: driven by a motion it responds with an effort (impedance causality).
///
/// A wall, a spring, a hold, a delay, a saturation, a stabilized port are all one-ports. What acts on a port
/// owns it and is a one-port again, so they chain like iterator adaptors, innermost first.
pub trait OnePort<V: Signal> {
    /// The effort in answer to the sample, N, positive against motion into the environment.
    fn respond(&mut self, sample: &PortSample<V>) -> V;

    /// What the stabilizer inside did on the last tick; an adaptor hands on that of the port it owns.
    ///
    /// Check an adaptor of your own with [`laws::adaptor`](crate::laws::adaptor).
    #[inline(always)]
    fn correction(&self) -> Correction<V> {
        Correction::none(V::zero())
    }

    /// This port watched and corrected by `stabilizer`, at the rate at which the result is called.
    ///
    /// One stabilizer per port: nested ones would serve the same debt twice.
    fn stabilized<S: Stabilizer<V>>(self, stabilizer: S) -> Stabilized<Self, S, V>
    where
        Self: Sized,
    {
        Stabilized::new(self, stabilizer)
    }
}

impl<V: Signal, P: OnePort<V> + ?Sized> OnePort<V> for &mut P {
    #[inline(always)]
    fn respond(&mut self, sample: &PortSample<V>) -> V {
        (**self).respond(sample)
    }

    #[inline(always)]
    fn correction(&self) -> Correction<V> {
        (**self).correction()
    }
}
