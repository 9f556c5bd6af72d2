//! Links between the two ends of a channel.

use lyapunov::{
    Correction, Popc, PortSample, Scalar, Stabilizer,
    stabilizers::{
        DriftCompensated, NoStabilizer, TwoLayer, TwoPortSide, WaveFilter, WaveFollower,
        WaveTransform,
    },
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

    /// Returns the velocity commanded to the slave, the force on the slave, and the message to the master.
    fn at_slave(
        &mut self,
        slave: &Slave<'_, T>,
        arrived: Message<T>,
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
        slave: &Slave<'_, T>,
        (velocity, energy): Message<T>,
    ) -> (Correction<T>, T, Message<T>) {
        self.slave.receive(energy);
        let correction = self.slave.stabilize(slave.load, velocity);
        let pull = slave.coordination.pull(correction.effort);
        (correction, pull, (pull, self.slave.absorbed()))
    }
}

/// Link that sends the master's velocity there and the force on the slave back, and at each end gives only forces that
/// the tank there can pay. The port at the slave is the slave's own motion.
pub(super) struct Layers<T> {
    pub(super) master: TwoLayer<T>,
    pub(super) slave: TwoLayer<T>,
}

impl<T: Scalar> Link<T> for Layers<T> {
    fn at_master(
        &mut self,
        sample: &PortSample<T>,
        (force, energy): Message<T>,
    ) -> (Correction<T>, Message<T>) {
        self.master.receive(energy);
        let correction = self.master.stabilize(sample, force);
        (correction, (sample.velocity, self.master.sent()))
    }

    fn at_slave(
        &mut self,
        slave: &Slave<'_, T>,
        (velocity, energy): Message<T>,
    ) -> (Correction<T>, T, Message<T>) {
        self.slave.receive(energy);
        let given = self.slave.stabilize(slave.motion, -slave.coordination.pull(velocity));
        let pull = -given.effort;
        (Correction { effort: velocity, ..given }, pull, (pull, self.slave.sent()))
    }
}

/// Link that sends waves both ways, each past a filter. They report no energies: they carry them.
pub(super) struct Waves<T: Scalar> {
    pub(super) transform: WaveTransform<T>,
    pub(super) follower: WaveFollower<T>,
    pub(super) there: WaveFilter<T>,
    pub(super) back: WaveFilter<T>,
}

impl<T: Scalar> Link<T> for Waves<T> {
    fn at_master(
        &mut self,
        sample: &PortSample<T>,
        (back, _): Message<T>,
    ) -> (Correction<T>, Message<T>) {
        let (force, there) = self.transform.effort(sample.velocity, back);
        (Correction::none(force), (self.there.pass(there), T::of(0.0)))
    }

    fn at_slave(
        &mut self,
        slave: &Slave<'_, T>,
        (there, _): Message<T>,
    ) -> (Correction<T>, T, Message<T>) {
        let following =
            self.follower.follow(there, slave.coordination.error, slave.motion.velocity);
        let back = self.back.pass(following.back);
        (Correction::none(following.flow), following.effort, (back, T::of(0.0)))
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

/// The slave on one tick.
pub(super) struct Slave<'a, T: Scalar> {
    /// The commanded port as an admittance: the force comes in, the commanded velocity goes out.
    pub(super) load: &'a PortSample<T>,
    /// The slave's own motion, under the force against it.
    pub(super) motion: &'a PortSample<T>,
    pub(super) coordination: Coordination<T>,
}

/// Coordinating controller on one tick: a spring from the commanded position, and a damper from the velocity commanded
/// for the tick.
#[derive(Clone, Copy, Debug)]
pub(super) struct Coordination<T> {
    /// The stiffness, N/m.
    pub(super) stiffness: T,
    /// The damping, N·s/m.
    pub(super) damping: T,
    /// The commanded position less the slave's, m.
    pub(super) error: T,
    /// The slave's velocity, m/s.
    pub(super) velocity: T,
}

impl<T: Scalar> Coordination<T> {
    /// The force on the slave under the commanded velocity `flow`, N.
    pub(super) fn pull(&self, flow: T) -> T {
        self.stiffness * self.error + self.damping * (flow - self.velocity)
    }
}
