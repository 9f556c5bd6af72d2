//! Energy and forces of a run on its true motion.

use super::force_felt::{ForceFelt, Ideal};
use super::given::{Given, device_damper};
use super::share::Split;
use super::stiffness_felt::StiffnessFelt;
use crate::files::Scene;
use crate::files::scene::Wall;
use crate::simulate::{Space, Tick};

/// Watches one run for what its port gave and how much of the environment was felt, whatever a stabilizer counted.
#[derive(Debug)]
pub(crate) struct Physical {
    given: Given<f64>,
    ideal: Ideal,
    force: ForceFelt<f64>,
    wall: Option<Wall>,
    stiffness: StiffnessFelt<f64>,
}

impl Physical {
    /// The meters of a run of `scene`.
    pub(crate) fn new(scene: &Scene) -> Self {
        Self {
            given: Given::new(device_damper(scene)),
            ideal: Ideal::of(scene),
            force: ForceFelt::new(),
            wall: scene.environment.wall().copied(),
            stiffness: StiffnessFelt::new(scene.servo_rate.get()),
        }
    }

    /// Adds one more tick, whose applied force is `split`.
    pub(crate) fn add<V: Space>(&mut self, tick: &Tick<V>, split: &Split) {
        let (force, moved) = (tick.applied.axis(0), tick.truth.displacement.axis(0));
        self.given.add(tick.truth.applied.axis(0) * moved, moved);
        self.force.add(force, self.ideal.force(tick));
        let surface = self.wall.map(|wall| wall.position.get());
        let depth = surface.map_or(0.0, |surface| tick.truth.position.axis(0) - surface);
        self.stiffness.add(force, split.environment, depth);
    }

    /// The most that the port had given, alone and beyond what the device's damper had taken, mJ.
    pub(crate) fn millijoules_given(&self) -> [f64; 2] {
        [self.given.by_port(), self.given.beyond_damper()].map(|energy| 1e3 * energy)
    }

    /// The force felt, percent of the environment's law.
    pub(crate) fn force_felt(&self) -> Option<f64> {
        self.force.percent(0)
    }

    /// The stiffness felt in long contacts, N/m and percent of the wall's.
    pub(crate) fn stiffness_felt(&self) -> Option<(f64, f64)> {
        let wall = self.wall?;
        let felt = self.stiffness.stiffness(0)?;
        Some((felt, 100.0 * felt / wall.stiffness.get()))
    }
}
