//! Curves of a run.

use lyapunov::Scalar;

use crate::files::Scene;
use crate::measure::{Summary, Trace};
use crate::simulate::{Space, Tick};

/// Curves of a run, in a bounded number of points however long it is.
#[derive(Clone, Debug)]
pub struct Curves {
    /// Along each axis of the scene.
    pub(super) axes: Vec<Axis>,
    /// The environment's force along the first axis, N.
    pub(super) environment: Trace,
    /// The energy that crossed the port, J.
    pub(super) port: Trace,
    /// The energy that the stabilizer observes, J.
    pub(super) observed: Trace,
}

/// Curves along one axis: the true position in m, the true velocity in m/s, the force on the plant in N.
#[derive(Clone, Debug)]
pub(super) struct Axis {
    pub(super) position: Trace,
    pub(super) velocity: Trace,
    pub(super) force: Trace,
}

impl Curves {
    /// Curves without points, for a run of `scene`.
    pub fn new(scene: &Scene) -> Self {
        let empty = Trace::new(scene.ticks());
        let axis = Axis { position: empty.clone(), velocity: empty.clone(), force: empty.clone() };
        Self {
            axes: vec![axis; scene.dimensions()],
            environment: empty.clone(),
            port: empty.clone(),
            observed: empty,
        }
    }

    /// Adds the tick that `summary` got last.
    pub fn add<V: Space>(&mut self, tick: &Tick<V>, summary: &Summary) {
        for (index, axis) in self.axes.iter_mut().enumerate() {
            axis.position.add(tick.time, tick.truth.position.axis(index));
            axis.velocity.add(tick.time, tick.truth.velocity.axis(index));
            axis.force.add(tick.time, tick.applied.axis(index));
        }
        self.environment.add(tick.time, tick.environment.axis(0));
        self.port.add(tick.time, summary.absorbed);
        self.observed.add(tick.time, tick.correction.observed_energy.lane(0));
    }
}
