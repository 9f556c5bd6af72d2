//! Energy and forces of a run on its true motion.

use std::fmt;

use lyapunov::Signal;
use lyapunov::environments::{NearestPoint, Solid};

use super::force_felt::{ForceFelt, Ideal};
use super::given::{Given, device_damper};
use super::share::Split;
use super::stiffness_felt::StiffnessFelt;
use crate::files::Scene;
use crate::simulate::{Space, Tick};

/// Watches one run for what its port gave and how much of the environment was felt, whatever a stabilizer counted.
pub(crate) struct Physical<V: Signal> {
    given: Given<V>,
    ideal: Ideal<V>,
    force: ForceFelt<V>,
    solid: Option<Box<dyn Solid<V>>>,
    /// Stiffness of the environment beyond its surface, N/m.
    asked: Option<f64>,
    stiffness: StiffnessFelt<f64>,
}

impl<V: Signal> fmt::Debug for Physical<V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Physical").finish_non_exhaustive()
    }
}

impl<V: Space<Scalar = f64>> Physical<V> {
    /// The meters of a run of `scene`.
    pub(crate) fn new(scene: &Scene) -> Self {
        Self {
            given: Given::new(device_damper(scene)),
            ideal: Ideal::of(scene),
            force: ForceFelt::new(),
            solid: V::solid(scene),
            asked: scene.environment.surface_stiffness(),
            stiffness: StiffnessFelt::new(scene.servo_rate.get()),
        }
    }

    /// Adds one more tick, whose applied force is `split`.
    pub(crate) fn add<S: Space<Double = V>>(&mut self, tick: &Tick<S>, split: &Split<V>) {
        let (force, moved) = (tick.applied.double(), tick.truth.displacement.double());
        self.given.add(tick.truth.applied.double().inner(moved), moved);
        self.force.add(force, self.ideal.force(tick));
        if let Some(solid) = &self.solid {
            let NearestPoint { depth, normal } = solid.nearest(tick.truth.position.double());
            // A force that pushes out along the normal is felt as one against it.
            let inward = V::zero() - normal;
            self.stiffness.add(force.inner(inward), split.environment.length(), depth);
        }
    }

    /// The most that the port had given, alone and beyond what the device's damper had taken, mJ.
    pub(crate) fn millijoules_given(&self) -> [f64; 2] {
        [self.given.by_port(), self.given.beyond_damper()].map(|energy| 1e3 * energy)
    }

    /// The force felt, percent of the environment's law.
    pub(crate) fn force_felt(&self) -> Option<f64> {
        self.force.percent(0)
    }

    /// The stiffness felt in long contacts, N/m and percent of the environment's.
    pub(crate) fn stiffness_felt(&self) -> Option<(f64, f64)> {
        let felt = self.stiffness.stiffness(0)?;
        Some((felt, 100.0 * felt / self.asked?))
    }
}
