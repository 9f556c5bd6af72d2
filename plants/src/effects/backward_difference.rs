//! Backward-difference velocity.

use lyapunov_core::{Correction, OnePort, PortSample, Signal};

/// A port whose velocities are taken from displacements, `v(n) = Δx(n) / T`: the backward difference.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BackwardDifference<P> {
    port: P,
}

impl<P> BackwardDifference<P> {
    pub(crate) fn new(port: P) -> Self {
        Self { port }
    }

    /// The port inside, which receives them.
    #[inline(always)]
    pub fn port(&self) -> &P {
        &self.port
    }
}

impl<V: Signal, P: OnePort<V>> OnePort<V> for BackwardDifference<P> {
    #[inline(always)]
    fn respond(&mut self, sample: &PortSample<V>) -> V {
        let velocity = sample.displacement.map(|moved| moved / sample.period);
        self.port.respond(&PortSample { velocity, ..*sample })
    }

    #[inline(always)]
    fn correction(&self) -> Correction<V> {
        self.port.correction()
    }
}
