//! Virtual mass-spring-damper, the paper's example 2.

use lyapunov_core::{Dissipation, OnePort, ParameterError, PortSample, Scalar, Signal, Snapshot};

use crate::{ForceLaw, Impedance, Kinematics};

/// A virtual mass-spring-damper, `f = m a + b v + k (x − position)`: the paper's example 2 (equation 14),
/// two-sided.
///
/// `a = (v(n) − v(n−1)) / T` with `T` the time since the last call, 0 on the first one and after a velocity that is not
/// finite. Behind a hold that is the time between two answers, not the period of the servo loop.
#[derive(Clone, Copy, Debug)]
pub struct MassSpringDamper<V: Signal> {
    impedance: Impedance<V::Scalar>,
    damper: Dissipation<V::Scalar>,
    position: V,
    velocity: Option<V>,
}

impl<V: Signal> MassSpringDamper<V> {
    /// A mass-spring-damper relaxed at the origin.
    ///
    /// # Errors
    /// A mass, damping or stiffness that is infinite or NaN; negative ones make an active environment.
    pub fn new(impedance: Impedance<V::Scalar>) -> Result<Self, ParameterError> {
        let impedance = impedance.finite()?;
        let damper = Dissipation::of(impedance.damping.larger(Scalar::of(0.0)))?;
        Ok(Self { impedance, damper, position: V::zero(), velocity: None })
    }

    /// The same mass-spring-damper, relaxed at `position`, m.
    #[must_use]
    pub fn at(self, position: V) -> Self {
        Self { position, ..self }
    }

    /// The credit of its own damper, `max(b, 0) v² T` at every tick: with
    /// [`PortEnergy`](lyapunov_core::PortEnergy) the candidate of the paper's example 2.
    ///
    /// A negative damping generates energy; the port's work counts it, not this credit.
    pub fn dissipation(&self) -> Dissipation<V::Scalar> {
        self.damper
    }
}

impl<V: Signal> ForceLaw<V> for MassSpringDamper<V> {
    #[inline(always)]
    fn force(&self, motion: &Kinematics<V>) -> V {
        let Impedance { mass, damping, stiffness } = self.impedance;
        motion.acceleration.scale(mass)
            + motion.velocity.scale(damping)
            + (motion.position - self.position).scale(stiffness)
    }

    fn stored(&self, motion: &Kinematics<V>) -> V::Scalar {
        let Impedance { mass, stiffness, .. } = self.impedance;
        let (away, velocity) = (motion.position - self.position, motion.velocity);
        let stored = away.scale(stiffness).inner(away) + velocity.scale(mass).inner(velocity);
        V::Scalar::of(0.5) * stored
    }
}

impl<V: Signal> OnePort<V> for MassSpringDamper<V> {
    #[inline(always)]
    fn respond(&mut self, sample: &PortSample<V>) -> V {
        let last = self.velocity.unwrap_or(sample.velocity);
        let gained = V::choose(last.finite(), sample.velocity - last, V::zero());
        self.velocity = Some(sample.velocity);
        let acceleration = gained.map(|change| change / sample.period);
        self.force(&Kinematics { acceleration, ..Kinematics::of(sample) })
    }
}

impl<V: Signal> Snapshot for MassSpringDamper<V> {
    /// The last velocity, m/s; none before the first call.
    type State = Option<V>;

    fn state(&self) -> Option<V> {
        self.velocity
    }

    fn restored(self, velocity: Option<V>) -> Result<Self, ParameterError> {
        Ok(Self { velocity, ..self })
    }
}
