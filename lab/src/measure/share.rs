//! Shares of environment and controller in the applied force.

use std::mem::replace;

use lyapunov::{Scalar, Signal};

use crate::files::Scene;
use crate::simulate::{Space, Tick};

/// The applied force, split into the environment's and the controller's share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Split<V> {
    /// The environment's force that is due now, before saturation, N: `f_env(n − d)`, 0 for `n < d`.
    pub(crate) late: V,
    /// The environment's share, N: `f_e(n) = clip(f_env(n − d))`, the force that would act now without a controller.
    pub(crate) environment: V,
    /// The rest of the applied force, N: the controller's share.
    pub(crate) controller: V,
}

/// Splits the applied force tick by tick: saturates and delays the environment's force as the loop does the whole.
#[derive(Clone, Debug)]
pub(crate) struct Share<V: Signal> {
    limit: V::Scalar,
    /// The environment's forces that do not act yet, and the place of the oldest.
    waiting: Vec<V>,
    oldest: usize,
}

impl<V: Signal> Share<V> {
    /// The shares of forces that act `ticks` late, no larger than `limit` along any axis.
    pub(crate) fn late(ticks: usize, limit: V::Scalar) -> Self {
        Self { limit, waiting: vec![V::zero(); ticks], oldest: 0 }
    }

    /// Splits the applied force, of which the environment gave `environment` as it was commanded.
    #[inline(always)]
    pub(crate) fn of(&mut self, environment: V, applied: V) -> Split<V> {
        let late = match self.waiting.get_mut(self.oldest) {
            Some(oldest) => replace(oldest, environment),
            None => environment,
        };
        self.oldest = if self.oldest + 1 < self.waiting.len() { self.oldest + 1 } else { 0 };
        let (most, least) = (self.limit, -self.limit);
        let environment = late.map(|axis| {
            let clipped = V::Scalar::choose(axis.below(least), least, axis);
            V::Scalar::choose(clipped.above(most), most, clipped)
        });
        Split { late, environment, controller: applied - environment }
    }
}

impl<V: Space<Scalar = f64>> Share<V> {
    /// The shares in `scene`, whose loop computes in the scalar of `S`.
    pub(crate) fn new<S: Space<Double = V>>(scene: &Scene) -> Self {
        // Rounded as the loop rounds it.
        let limit = |force: f64| S::Scalar::of(force).lane(0);
        let limit = scene.effects.saturation.map_or(f64::INFINITY, |it| limit(it.force.get()));
        Self::late(scene.delay_ticks() as usize, limit)
    }

    /// Splits the force applied from `tick` on.
    pub(crate) fn split<S: Space<Double = V>>(&mut self, tick: &Tick<S>) -> Split<V> {
        self.of(tick.environment.double(), tick.applied.double())
    }

    /// Whether a force of the environment does not act yet.
    pub(crate) fn is_waiting(&self) -> bool {
        self.waiting.iter().any(|force| *force != V::zero())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::samples::scene;

    #[test]
    fn the_environment_s_share_is_clipped_and_late_as_the_whole_is() {
        let late = scene("effects.delay.ticks = 2\neffects.saturation.force = 3.0\n");
        let mut share = Share::new::<f64>(&late);
        let split = [1.0, 5.0, -7.0, 2.0].map(|force| share.of(force, 0.0));
        assert_eq!(split.map(|it| it.late), [0.0, 0.0, 1.0, 5.0]);
        assert_eq!(split.map(|it| it.environment), [0.0, 0.0, 1.0, 3.0]);
        assert!(share.is_waiting());

        let mut prompt = Share::new::<f64>(&scene(""));
        assert_eq!(prompt.of(4.0, 4.5), Split { late: 4.0, environment: 4.0, controller: 0.5 });
        assert!(!prompt.is_waiting());
    }

    #[test]
    fn the_limit_is_rounded_as_the_loop_rounds_it() {
        let clipped = scene("effects.saturation.force = 0.1\n");
        let split = |mut share: Share<f64>| share.of(1.0, 0.0).environment;
        assert_eq!(split(Share::new::<f64>(&clipped)), 0.1);
        assert_eq!(split(Share::new::<f32>(&clipped)), f64::from(0.1_f32));
    }
}
