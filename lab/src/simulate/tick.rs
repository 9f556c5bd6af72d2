//! One servo tick of a rollout.

use lyapunov::{Correction, Mask, PortSample, Scalar, Signal};

/// One servo tick of a [`Rollout`](crate::Rollout), along all axes and in all lanes of its signal.
///
/// Whatever is told of a run is derived from these: [`Row`](crate::Row)s, a [`Summary`](crate::Summary), comparisons and
/// energies by cause.
#[derive(Clone, Copy, Debug)]
pub struct Tick<V: Signal> {
    /// Time, s.
    pub time: f64,
    /// The plant's own sample, before anything measures it.
    pub truth: PortSample<V>,
    /// The sample as the stabilizer is told it.
    pub measured: PortSample<V>,
    /// The environment's effort, N.
    pub environment: V,
    /// What the stabilizer did.
    pub correction: Correction<V>,
    /// The effort commanded, after saturation, N.
    pub command: V,
    /// The effort that acts on the plant until the next tick, after delay, N.
    pub applied: V,
    /// The operator's motion, where a link sets it apart from the device's.
    pub operator: Option<OperatorMotion<V>>,
}

/// The motion of an operator that a link sets apart from the device.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OperatorMotion<V> {
    /// Position, m.
    pub position: V,
    /// Velocity, m/s.
    pub velocity: V,
}

impl<V: Signal> Tick<V> {
    /// The controller's effort as a damper, `α v`, N.
    pub fn control(&self) -> V {
        self.measured.velocity.scale(self.correction.alpha)
    }

    /// Whether the sample was accepted and everything that is told of the tick is finite, in the first lane.
    pub(crate) fn in_range(&self) -> bool {
        let Correction { observed_energy: sum, alpha, shortfall, accepted, .. } = self.correction;
        let signals = [
            self.truth.position,
            self.measured.position,
            self.measured.velocity,
            self.environment,
            self.control(),
            self.command,
            self.applied,
        ];
        let operator = self.operator.iter().flat_map(|it| [it.position, it.velocity]);
        Mask::all(accepted)
            && self.time.is_finite()
            && [sum, alpha, shortfall].iter().all(|number| number.lane(0).is_finite())
            && signals.into_iter().chain(operator).all(|signal| signal.finite().lane(0))
    }
}
