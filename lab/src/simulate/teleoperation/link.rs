//! Links between the two ends of a channel.

use lyapunov::{
    Correction, Popc, PortSample, Scalar, Stabilizer,
    stabilizers::{DriftCompensated, NoStabilizer, TwoPortSide, WaveTransform},
};

/// A signal, and the energy that its sender reports as absorbed, J.
pub(super) type Message<T> = (T, T);

/// Link that joins two devices by messages.
pub(super) trait Link<T: Scalar> {
    /// Returns the force on the master, and the message to the slave.
    fn at_master(
        &mut self,
        sample: &PortSample<T>,
        arrived: Message<T>,
    ) -> (Correction<T>, Message<T>);

    /// Returns the velocity commanded to the slave, the force on the slave, and the message to the master; `load` is
    /// the sample of the slave's port as an admittance.
    fn at_slave(
        &mut self,
        load: &PortSample<T>,
        arrived: Message<T>,
        coordination: &Coordination<T>,
    ) -> (Correction<T>, T, Message<T>);
}

/// Link that sends the master's velocity there and the force on the slave back, each past a stabilizer.
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

/// Link that sends waves both ways. They report no energies: they carry them.
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
        // The flow is v = v₀ − F / b with v₀ the flow at zero force, and F contains B v: solved for F.
        let (free, _) = self.transform.flow(T::of(0.0), there);
        let share = self.impedance / (self.impedance + coordination.damping());
        let pull = coordination.pull(free) * share;
        let (flow, back) = self.transform.flow(pull, there);
        (Correction::none(flow), pull, (back, T::of(0.0)))
    }
}

/// Stabilizer at one end of a link, which may receive energies and report its own; one that does neither works alone.
pub(super) trait End<T: Scalar>: Stabilizer<T> {
    /// Receives the energy that the other end reports as absorbed, J.
    fn receive(&mut self, _energy: T) {}

    /// The energy that this end has absorbed, J.
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

/// Coordinating controller on one tick: a spring from the commanded position, and a damper from the velocity commanded
/// for the tick.
#[derive(Clone, Copy, Debug)]
pub(super) struct Coordination<T> {
    /// The pull of the spring, N.
    spring: T,
    damping: T,
    /// The slave's velocity, m/s.
    velocity: T,
}

impl<T: Scalar> Coordination<T> {
    /// A spring of `stiffness` N/m and a damper of `damping` N·s/m that pull the slave at `sample` to `command` m.
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
