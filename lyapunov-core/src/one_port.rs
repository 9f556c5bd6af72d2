//! One-port: anything that responds to a motion with an effort.

use crate::{Correction, PortSample, Signal, Stabilized, Stabilizer};

/// System with one port, which responds to a motion with an effort (impedance causality).
///
/// A wall, a spring, a hold, a delay, a saturation, a stabilized port are all one-ports. An effect on a port owns that
/// port and is a one-port again, so effects chain like iterator adaptors, innermost first.
///
/// ```
/// use lyapunov_core::{OnePort, PortSample};
/// /// Springs that face each other, `width` m apart.
/// struct Slot { stiffness: f64, width: f64 }
/// impl OnePort<f64> for Slot {
///     fn respond(&mut self, sample: &PortSample<f64>) -> f64 {
///         let beyond = sample.position.abs() - 0.5 * self.width;
///         self.stiffness * beyond.max(0.0) * sample.position.signum()
///     }
/// }
/// let effort = Slot { stiffness: 1e3, width: 0.02 }.respond(&PortSample::starting(1e-3, -0.012, 0.0));
/// assert!((effort + 2.0).abs() < 1e-12); // pushes back inwards
/// ```
pub trait OnePort<V: Signal> {
    /// The effort in response to the sample, N, positive against motion into the environment.
    fn respond(&mut self, sample: &PortSample<V>) -> V;

    /// The last correction of the stabilizer inside; an adaptor hands on that of the port it owns.
    ///
    /// Check an adaptor of your own with [`laws::adaptor`](crate::laws::adaptor).
    #[inline(always)]
    fn correction(&self) -> Correction<V> {
        Correction::none(V::zero())
    }

    /// This port with `stabilizer` in front, which watches and corrects it at the rate at which the result is called.
    ///
    /// One stabilizer per port: nested ones would serve the same debt twice.
    #[must_use]
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
