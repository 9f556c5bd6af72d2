//! What the two ends of a channel make of their messages.

use lyapunov::{
    Correction, Popc, PortSample, Scalar, Stabilizer,
    stabilizers::{DriftCompensated, NoStabilizer, TwoPortSide, WaveTransform},
};

/// A signal, and what its sender tells that it has absorbed, J.
pub(super) type Message<T> = (T, T);

/// How two devices are joined by messages.
pub(super) trait Link<T: Scalar> {
    /// The force on the master, and the message to the slave.
    fn at_master(
        &mut self,
        sample: &PortSample<T>,
        arrived: Message<T>,
    ) -> (Correction<T>, Message<T>);

    /// The velocity that the slave is commanded, the force on the slave, and the message to the master; `load` tells of
    /// the slave's port as an admittance.
    fn at_slave(
        &mut self,
        load: &PortSample<T>,
        arrived: Message<T>,
        coordination: &Coordination<T>,
    ) -> (Correction<T>, T, Message<T>);
}

/// The master's velocity travels there and the force on the slave back, each past a stabilizer.
pub(super) struct Velocities<T> {
    pub(super) master: Box<dyn End<T>>,
    pub(super) slave: Box<dyn End<T>>,
}

impl<T: Scalar> Link<T> for Velocities<T> {
    fn at_master(
        &mut self,
        sample: &PortSample<T>,
        (force, energy): Message<T>,
    ) -> (Correction<T>, Message<T>) {
        self.master.receive(energy);
        let correction = self.master.stabilize(sample, force);
        (correction, (sample.velocity, self.master.absorbed()))
    }

    fn at_slave(
        &mut self,
        load: &PortSample<T>,
        (velocity, energy): Message<T>,
        coordination: &Coordination<T>,
    ) -> (Correction<T>, T, Message<T>) {
        self.slave.receive(energy);
        let correction = self.slave.stabilize(load, velocity);
        let pull = coordination.pull(correction.effort);
        (correction, pull, (pull, self.slave.absorbed()))
    }
}

/// Waves travel both ways. They tell of no energies: they carry them.
pub(super) struct Waves<T> {
    pub(super) transform: WaveTransform<T>,
    /// The impedance `b` of the transform, N·s/m.
    pub(super) impedance: T,
}

impl<T: Scalar> Link<T> for Waves<T> {
    fn at_master(
        &mut self,
        sample: &PortSample<T>,
        (back, _): Message<T>,
    ) -> (Correction<T>, Message<T>) {
        let (force, there) = self.transform.effort(sample.velocity, back);
        (Correction::none(force), (there, T::of(0.0)))
    }

    fn at_slave(
        &mut self,
        _load: &PortSample<T>,
        (there, _): Message<T>,
        coordination: &Coordination<T>,
    ) -> (Correction<T>, T, Message<T>) {
        // The flow is v = v₀ − F / b with v₀ that of no force, and F has B v in it: solved for F.
        let (free, _) = self.transform.flow(T::of(0.0), there);
        let share = self.impedance / (self.impedance + coordination.damping());
        let pull = coordination.pull(free) * share;
        let (flow, back) = self.transform.flow(pull, there);
        (Correction::none(flow), pull, (back, T::of(0.0)))
    }
}

/// A stabilizer at one end of a link, which may be told of energies and tell of its own; one that does neither is alone.
pub(super) trait End<T: Scalar>: Stabilizer<T> {
    /// Takes what the other end tells that it has absorbed, J.
    fn receive(&mut self, _energy: T) {}

    /// What this end has absorbed, J.
    fn absorbed(&self) -> T {
        T::of(0.0)
    }
}

impl<T: Scalar> End<T> for NoStabilizer {}

impl<T: Scalar> End<T> for Popc<T> {}

impl<T: Scalar> End<T> for TwoPortSide<T> {
    fn receive(&mut self, energy: T) {
        Self::receive(self, energy);
    }

    fn absorbed(&self) -> T {
        Self::absorbed(self)
    }
}

impl<T: Scalar> End<T> for DriftCompensated<TwoPortSide<T>, T> {
    fn receive(&mut self, energy: T) {
        Self::receive(self, energy);
    }

    fn absorbed(&self) -> T {
        Self::absorbed(self)
    }
}

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
