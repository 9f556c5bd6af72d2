//! What the two ends of a channel make of their messages.

use lyapunov::{Correction, PortSample, Scalar, stabilizers::WaveTransform};

use super::coordination::Coordination;
use super::end::End;

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
