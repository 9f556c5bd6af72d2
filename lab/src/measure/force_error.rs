//! Error of the force on the plant in contact.

use std::fmt;

use lyapunov::environments::Solid;
use lyapunov::{Scalar, Signal};

use super::law::{Law, Motion};
use crate::files::Scene;
use crate::simulate::Space;

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

/// Force error of a run against the wall or the solid of its scene: one definition for all studies that tell it.
pub(crate) struct SolidError<V: Signal> {
    solid: Box<dyn Solid<V>>,
    law: Law<V>,
    error: ForceError<V>,
}

impl<V: Signal> fmt::Debug for SolidError<V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("SolidError").field("error", &self.error).finish_non_exhaustive()
    }
}

impl<V: Space<Scalar = f64>> SolidError<V> {
    /// A meter that has felt nothing; none in a scene without a wall or a solid.
    pub(crate) fn of(scene: &Scene) -> Option<Self> {
        let solid = V::solid(scene)?;
        Some(Self { solid, law: Law::of(scene), error: ForceError::new() })
    }

    /// Adds one more tick: the true position and velocity, the force on the plant, and the environment's share of it.
    pub(crate) fn add(&mut self, [position, velocity]: [V; 2], force: V, environment: V) {
        // Walls and solids stand still, and have no mass.
        let ideal =
            self.law.force(Motion { time: 0.0, position, velocity, acceleration: V::zero() });
        let depth = self.solid.nearest(position).depth;
        self.error.add(force, ideal, environment.length(), depth);
    }

    /// The root mean square, N; none without a contact.
    pub(crate) fn root_mean_square(&self) -> Option<f64> {
        self.error.root_mean_square(0)
    }
}
