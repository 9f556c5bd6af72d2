//! Velocity as it is usually had.

use lyapunov_core::{Action, Drive, OnePort, Signal};

/// A port that is told velocities taken from displacements, `v(n) = Δx(n) / T`: the backward difference.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference<P> {
    port: P,
}

impl<P> Difference<P> {
    pub(crate) fn new(port: P) -> Self {
        Self { port }
    }

    /// The port that is told them.
    #[inline(always)]
    pub fn port(&self) -> &P {
        &self.port
    }
}

impl<V: Signal, P: OnePort<V>> OnePort<V> for Difference<P> {
    #[inline(always)]
    fn respond(&mut self, drive: &Drive<V>) -> V {
        let velocity = drive.displacement.map(|moved| moved / drive.period);
        self.port.respond(&Drive { velocity, ..*drive })
    }

    #[inline(always)]
    fn action(&self) -> Action<V> {
        self.port.action()
    }
}
