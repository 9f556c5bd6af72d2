//! Share of the environment's own force that is felt.

use lyapunov::Scalar;

use super::law::{Law, Motion};
use crate::files::scene::Scene;
use crate::simulate::{Space, Tick};

/// Watches the factor that fits the applied force to the environment's own law on the true motion, `f*`: the `c` of the
/// least `Σ (f_act − c f*)²`, which is `Σ f_act f* / Σ f*²`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ForceFelt<T> {
    product: T,
    square: T,
}

impl<T: Scalar> ForceFelt<T> {
    /// A meter that has felt nothing.
    pub(crate) fn new() -> Self {
        Self { product: T::zero(), square: T::zero() }
    }

    /// Adds one more tick: the force applied from here on, and the one that the law gives here.
    #[inline(always)]
    pub(crate) fn add(&mut self, applied: T, ideal: T) {
        self.product += applied * ideal;
        self.square += ideal * ideal;
    }

    /// The factor in a lane, in percent; none where the law never gave a force.
    pub(crate) fn percent(&self, lane: usize) -> Option<f64> {
        let square = self.square.lane(lane);
        (square > 0.0).then(|| 100.0 * self.product.lane(lane) / square)
    }
}

/// The law of a scene's environment on a run's true motion.
#[derive(Debug)]
pub(crate) struct Ideal(Option<Law>);

impl Ideal {
    /// The law of `scene`; unknown of an environment with a mass, since no tick has an acceleration.
    pub(crate) fn of(scene: &Scene) -> Self {
        let impedance = scene.environment.kind().impedance();
        let is_massless = impedance.is_none_or(|it| it.mass == 0.0);
        Self(is_massless.then(|| Law::of(scene)))
    }

    /// The force that the law gives at `tick`, N; 0 where it is unknown.
    pub(crate) fn force<V: Space>(&self, tick: &Tick<V>) -> f64 {
        let (position, velocity) = (tick.truth.position.axis(0), tick.truth.velocity.axis(0));
        let motion = Motion { time: tick.time, position, velocity, acceleration: 0.0 };
        self.0.as_ref().map_or(0.0, |law| law.force(motion))
    }
}
