//! Saturation of the actuator.

use lyapunov_core::{
    Correction, OnePort, ParameterError, PortSample, Requirement, Scalar, Signal, Snapshot,
};

/// A port whose effort is clipped to `±force` on each axis; a NaN stays one.
///
/// The sample reports the applied effort to a stabilizer inside, so its ledger is right without further care.
///
/// ```
/// use lyapunov_core::{OnePort, PortSample};
/// use lyapunov_plants::{OnePortExt, Spring};
/// let mut motor = Spring::new(500.0)?.saturated(5.0)?;
/// assert_eq!(motor.respond(&PortSample::starting(1e-3, -0.1_f64, 0.0)), -5.0);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Saturation<P, T> {
    port: P,
    force: T,
}

lends_port!([P, T] Saturation<P, T>);

impl<P, T: Scalar> Saturation<P, T> {
    pub(crate) fn new(port: P, force: T) -> Result<Self, ParameterError> {
        Ok(Self { port, force: Requirement::Positive.check("saturation force", force)? })
    }
}

impl<V: Signal, P: OnePort<V>> OnePort<V> for Saturation<P, V::Scalar> {
    #[inline(always)]
    fn respond(&mut self, sample: &PortSample<V>) -> V {
        self.port.respond(sample).limited(self.force)
    }

    #[inline(always)]
    fn correction(&self) -> Correction<V> {
        self.port.correction()
    }
}

lyapunov_core::snapshot!(impl[P: Snapshot, T: Scalar] Saturation<P, T>, is port, of P::State);
