//! The slave's controller.

use lyapunov::{PortSample, Scalar};

/// The coordinating controller on one tick: a spring from the commanded position, and a damper from the velocity that is
/// commanded for the tick.
#[derive(Clone, Copy, Debug)]
pub(super) struct Coordination<T> {
    /// What the spring pulls, N.
    spring: T,
    damping: T,
    /// The slave's velocity, m/s.
    velocity: T,
}

impl<T: Scalar> Coordination<T> {
    /// A spring of `stiffness` N/m and a damper of `damping` N·s/m that pull the slave, of which `sample` tells, to `command` m.
    pub(super) fn new(stiffness: T, damping: T, command: T, sample: &PortSample<T>) -> Self {
        let spring = stiffness * (command - sample.position);
        Self { spring, damping, velocity: sample.velocity }
    }

    /// The force on the slave under the commanded velocity `flow`, N.
    pub(super) fn pull(&self, flow: T) -> T {
        self.spring + self.damping * (flow - self.velocity)
    }

    /// The damping, N·s/m.
    pub(super) fn damping(&self) -> T {
        self.damping
    }
}
