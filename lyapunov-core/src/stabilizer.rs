//! Stabilizers: the trait, and a port with a stabilizer in front.

use crate::{Correction, OnePort, ParameterError, PortSample, Signal, Snapshot};

/// Stabilizer: it watches a port and corrects its effort, so that the loop stays bounded.
///
/// Impedance causality: motion comes in, effort goes out. For admittance causality give it an
/// [`AdmittanceSample`](crate::AdmittanceSample) as the sample and a flow as the effort; it then adds a velocity in
/// proportion to the force.
///
/// A stabilizer never fails in the loop. A sample that it cannot use gives `accepted` false and a zero effort, or what a watchdog holds.
/// Check one of your own with [`laws::stabilizer`](crate::laws::stabilizer).
///
/// ```
/// use lyapunov_core::{Correction, PortSample, Stabilizer};
/// /// A damper of `damping` N·s/m that is always on.
/// struct Damper {
///     damping: f64,
/// }
/// impl Stabilizer<f64> for Damper {
///     fn stabilize(&mut self, sample: &PortSample<f64>, effort: f64) -> Correction<f64> {
///         let effort = effort + self.damping * sample.velocity;
///         Correction { alpha: self.damping, ..Correction::none(effort) }.checked()
///     }
/// }
/// let braked = Damper { damping: 3.0 }.stabilize(&PortSample::starting(1e-3, 0.0, 0.1), 1.0);
/// assert!((braked.effort - 1.3).abs() < 1e-15);
/// ```
pub trait Stabilizer<V: Signal> {
    /// One tick: `sample` is what the other side did, `effort` the response of the port behind, N: positive against a
    /// motion into the environment ([`OnePort::respond`]), so that a motor pushes with `−effort`.
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V>;
}

impl<V: Signal, S: Stabilizer<V> + ?Sized> Stabilizer<V> for &mut S {
    #[inline(always)]
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        (**self).stabilize(sample, effort)
    }
}

/// Port with a stabilizer in front: [`OnePort::stabilized`].
#[derive(Clone, Copy, Debug)]
pub struct Stabilized<P, S, V: Signal> {
    port: P,
    stabilizer: S,
    correction: Correction<V>,
}

impl<P, S, V: Signal> Stabilized<P, S, V> {
    pub(crate) fn new(port: P, stabilizer: S) -> Self {
        Self { port, stabilizer, correction: Correction::none(V::zero()) }
    }

    /// The watched port.
    #[inline(always)]
    pub fn port(&self) -> &P {
        &self.port
    }

    /// The watched port, to be changed between ticks.
    #[inline]
    pub fn port_mut(&mut self) -> &mut P {
        &mut self.port
    }

    /// The stabilizer in front of it.
    #[inline]
    pub fn stabilizer(&self) -> &S {
        &self.stabilizer
    }

    /// The stabilizer in front of it, to be changed between ticks.
    #[inline]
    pub fn stabilizer_mut(&mut self) -> &mut S {
        &mut self.stabilizer
    }
}

impl<V: Signal, P: OnePort<V>, S: Stabilizer<V>> OnePort<V> for Stabilized<P, S, V> {
    #[inline(always)]
    fn respond(&mut self, sample: &PortSample<V>) -> V {
        let effort = self.port.respond(sample);
        self.correction = self.stabilizer.stabilize(sample, effort);
        self.correction.effort
    }

    #[inline(always)]
    fn correction(&self) -> Correction<V> {
        self.correction
    }
}

impl<P: Snapshot, S: Snapshot, V: Signal> Snapshot for Stabilized<P, S, V> {
    /// The memory of the port, that of the stabilizer, and the last correction: no step reads it, so it is taken as it is.
    type State = (P::State, S::State, Correction<V>);

    fn state(&self) -> Self::State {
        (self.port.state(), self.stabilizer.state(), self.correction)
    }

    fn restored(self, (port, stabilizer, correction): Self::State) -> Result<Self, ParameterError> {
        let (port, stabilizer) = (self.port.restored(port)?, self.stabilizer.restored(stabilizer)?);
        Ok(Self { port, stabilizer, correction })
    }
}
