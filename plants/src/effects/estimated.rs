//! Velocities estimated in front of a port.

use lyapunov_core::{
    Correction, Differenced, LowPassed, OnePort, ParameterError, PortSample, Signal, Snapshot,
    VelocityEstimator, Windowed,
};

/// A port whose velocities are estimated from positions and displacements. Positions, displacements and work stay as
/// they are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimated<P, E> {
    port: P,
    velocity: E,
}

lends_port!([P, E] Estimated<P, E>);

/// A port whose velocities are [backward differences](Differenced).
///
/// ```
/// use lyapunov_core::{HeldTick, OnePort};
/// use lyapunov_plants::{OnePortExt, Wall};
/// let mut damper = Wall::new(0.0, 2.0)?.at(-1.0).differenced();
/// let tick = HeldTick { period: 1e-3, position: 0.0, velocity: 9.0, displacement: 1e-4, applied: 0.0 };
/// let effort: f64 = damper.respond(&tick.sample()); // of 0.1 m/s, and not of the 9 m/s that were told
/// assert!((effort - 0.2).abs() < 1e-12);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
pub type BackwardDifference<P> = Estimated<P, Differenced>;

/// A port whose velocities pass a [low pass](LowPassed).
pub type LowPass<P, V> = Estimated<P, LowPassed<V>>;

/// A port whose velocities are taken over an [adaptive window](Windowed) of calls.
pub type AdaptiveWindow<P, V, const N: usize> = Estimated<P, Windowed<V, N>>;

impl<P, E> Estimated<P, E> {
    pub(crate) fn new(port: P, velocity: E) -> Self {
        Self { port, velocity }
    }
}

impl<V: Signal, P: OnePort<V>, E: VelocityEstimator<V>> OnePort<V> for Estimated<P, E> {
    #[inline(always)]
    fn respond(&mut self, sample: &PortSample<V>) -> V {
        let velocity = self.velocity.velocity(sample);
        self.port.respond(&PortSample { velocity, ..*sample })
    }

    #[inline(always)]
    fn correction(&self) -> Correction<V> {
        self.port.correction()
    }
}

impl<P: Snapshot, E: Snapshot> Snapshot for Estimated<P, E> {
    /// The memory of the port inside, and the estimator's.
    type State = (P::State, E::State);

    fn state(&self) -> Self::State {
        (self.port.state(), self.velocity.state())
    }

    fn restored(self, (port, velocity): Self::State) -> Result<Self, ParameterError> {
        let port = self.port.restored(port)?;
        Ok(Self { port, velocity: self.velocity.restored(velocity)? })
    }
}
