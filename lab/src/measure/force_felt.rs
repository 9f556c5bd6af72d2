//! Share of the environment's own force that is felt.

use lyapunov::{Scalar, Signal};

use super::law::{Law, Motion};
use crate::files::scene::Scene;
use crate::simulate::{Space, Tick};

/// Watches the factor that fits the applied force to the environment's own law on the true motion, `f*`: the `c` of the
/// least `Σ (f_act − c f*)²`, which is `Σ f_act f* / Σ f*²`, in several dimensions with inner products.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ForceFelt<V: Signal> {
    product: V::Scalar,
    square: V::Scalar,
}

impl<V: Signal> ForceFelt<V> {
    /// A meter that has felt nothing.
    pub(crate) fn new() -> Self {
        let zero = V::Scalar::of(0.0);
        Self { product: zero, square: zero }
    }

    /// Adds one more tick: the force applied from here on, and the one that the law gives here.
    #[inline(always)]
    pub(crate) fn add(&mut self, applied: V, ideal: V) {
        self.product += applied.inner(ideal);
        self.square += ideal.inner(ideal);
    }

    /// The factor in a lane, in percent; none where the law never gave a force.
    pub(crate) fn percent(&self, lane: usize) -> Option<f64> {
        let square = self.square.lane(lane);
        (square > 0.0).then(|| 100.0 * self.product.lane(lane) / square)
    }
}

/// The law of a scene's environment on a run's true motion.
#[derive(Debug)]
pub(crate) struct Ideal<V: Signal>(Option<Law<V>>);

impl<V: Space<Scalar = f64>> Ideal<V> {
    /// The law of `scene`; unknown of an environment with a mass, since no tick has an acceleration.
    pub(crate) fn of(scene: &Scene) -> Self {
        let impedance = scene.environment.kind().impedance();
        let is_massless = impedance.is_none_or(|it| it.mass == 0.0);
        Self(is_massless.then(|| Law::of(scene)))
    }

    /// The force that the law gives at `tick`, N; 0 where it is unknown.
    pub(crate) fn force<S: Space<Double = V>>(&self, tick: &Tick<S>) -> V {
        let (position, velocity) = (tick.truth.position.double(), tick.truth.velocity.double());
        let motion = Motion { time: tick.time, position, velocity, acceleration: V::zero() };
        self.0.as_ref().map_or(V::zero(), |law| law.force(motion))
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::measure::samples::scene;
    use crate::simulate::Rollout;

    #[test]
    fn a_scaled_law_is_felt_by_its_factor() {
        let mut felt = ForceFelt::<f64>::new();
        assert_eq!(felt.percent(0), None);
        for n in 0..100 {
            let law = f64::from(n).sin().max(0.0);
            // What stands across the law, and what acts where it gives nothing, is no part of it.
            let across = if n % 2 == 0 { 3.0 } else { -3.0 } * f64::from(u8::from(law == 0.0));
            felt.add(0.25 * law + across, law);
        }
        assert_relative_eq!(felt.percent(0).unwrap(), 25.0, max_relative = 1e-12);
    }

    /// `percent` over a run, with the force in place of the applied one.
    fn percent(scene: &Scene, force: impl Fn(&Tick<f64>) -> f64) -> Option<f64> {
        let (mut felt, ideal) = (ForceFelt::<f64>::new(), Ideal::<f64>::of(scene));
        let ticks = Rollout::<f64>::of(scene).unwrap();
        ticks.for_each(|tick| felt.add(force(&tick), ideal.force(&tick)));
        felt.percent(0)
    }

    #[test]
    fn the_law_is_the_environment_s_on_the_true_motion() {
        let wall = scene("effects.encoder.resolution = 1e-3\nvelocity = \"exact\"\n");
        let asked = |tick: &Tick<f64>| {
            let (x, v) = (tick.truth.position, tick.truth.velocity);
            if x > 1e-3 { (1e3 * (x - 1e-3) + 2.0 * v).max(0.0) } else { 0.0 }
        };
        assert_relative_eq!(percent(&wall, asked).unwrap(), 100.0, max_relative = 1e-12);
        // The encoder's steps are a part of what acts and none of the law.
        let acts = percent(&wall, |tick| tick.applied).unwrap();
        assert!((acts - 100.0).abs() > 0.1, "{acts}");
        let still = scene("initial.position = 0.0\n");
        assert_eq!(percent(&still, |tick| tick.applied), None);
    }

    #[test]
    fn without_an_acceleration_the_law_of_a_mass_is_unknown() {
        let base = "duration = 1.0\nservo_rate = 100.0\ndevice.mass = 0.3\noperator.stiffness = 50.0\n\
            initial.position = -0.004\n";
        let with = |environment: &str| {
            let text = format!("{base}environment.{environment}\n");
            let scene = Scene::parse(&text, "test").unwrap();
            percent(&scene, |tick| tick.applied)
        };
        assert_eq!(with("mass-spring-damper = { mass = 0.1, stiffness = 9.0 }"), None);
        assert!(with("mass-spring-damper = { damping = 0.1, stiffness = 9.0 }").is_some());
        assert!(with("spring = { stiffness = 9.0 }").is_some());
    }
}
