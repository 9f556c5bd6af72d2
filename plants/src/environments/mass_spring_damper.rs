//! The paper's example 2.

use lyapunov_core::{Drive, OnePort, ParameterError, Signal};

use crate::Impedance;

/// A virtual mass-spring-damper, `f = m a + b v + k (x − position)`: the paper's example 2 (equation 14),
/// two-sided.
///
/// `a = (v(n) − v(n−1)) / period`, 0 on the first call.
#[derive(Clone, Copy, Debug)]
pub struct MassSpringDamper<V: Signal> {
    impedance: Impedance<V::Scalar>,
    position: V,
    velocity: Option<V>,
}

impl<V: Signal> MassSpringDamper<V> {
    /// A mass-spring-damper relaxed at the origin.
    ///
    /// # Errors
    /// A mass, damping or stiffness that is infinite or NaN; negative ones make an active environment.
    pub fn new(impedance: Impedance<V::Scalar>) -> Result<Self, ParameterError> {
        Ok(Self { impedance: impedance.finite()?, position: V::zero(), velocity: None })
    }

    /// The same, relaxed at `position`, m.
    pub fn at(self, position: V) -> Self {
        Self { position, ..self }
    }
}

impl<V: Signal> OnePort<V> for MassSpringDamper<V> {
    #[inline]
    fn respond(&mut self, drive: &Drive<V>) -> V {
        let Impedance { mass, damping, stiffness } = self.impedance;
        let gained = drive.velocity - self.velocity.unwrap_or(drive.velocity);
        self.velocity = Some(drive.velocity);
        gained.map(|change| mass * (change / drive.period))
            + drive.velocity.scale(damping)
            + (drive.position - self.position).scale(stiffness)
    }
}
