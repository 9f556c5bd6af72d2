//! Error of the force on the plant in contact.

use lyapunov::{Scalar, Signal};

/// Watches `f_act − f*`, the applied force less the environment's own law on the true motion, in contact: on the ticks on
/// which the plant is beyond the surface or pushed by the environment. A force that comes late or stays on too long is
/// an error as well.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ForceError<V: Signal> {
    square: V::Scalar,
    ticks: V::Scalar,
}

impl<V: Signal> ForceError<V> {
    /// A meter that has felt nothing.
    pub(crate) fn new() -> Self {
        let zero = V::Scalar::of(0.0);
        Self { square: zero, ticks: zero }
    }

    /// Adds one more tick: the applied force and the law's, the magnitude of the environment's part, and the depth below
    /// the surface.
    #[inline(always)]
    pub(crate) fn add(&mut self, applied: V, ideal: V, environment: V::Scalar, depth: V::Scalar) {
        let idle = environment.below(V::Scalar::smallest_positive());
        let (off, one) = (applied - ideal, V::Scalar::of(1.0));
        let counts = !idle | depth.above(V::Scalar::of(0.0));
        self.square = V::Scalar::choose(counts, self.square + off.inner(off), self.square);
        self.ticks = V::Scalar::choose(counts, self.ticks + one, self.ticks);
    }

    /// The root mean square in a lane, N; none without a contact.
    pub(crate) fn root_mean_square(&self, lane: usize) -> Option<f64> {
        let (square, ticks) = (self.square.lane(lane), self.ticks.lane(lane));
        (ticks > 0.0).then(|| (square / ticks).sqrt())
    }
}
