//! The trait of a stabilizer, and a port with one in front.

use crate::{Action, Drive, OnePort, Signal};

/// Watches a port and corrects its effort just enough, just in time, to keep the loop bounded.
///
/// Impedance causality: motion comes in, effort goes out. For admittance causality give it a [`Load`](crate::Load)
/// as the drive and a flow as the effort; what it adds is then a velocity in proportion to the force.
///
/// A stabilizer never fails in the loop. A sample it cannot use gives a zero effort and `accepted` false.
/// Check one of your own with [`laws::stabilizer`](crate::laws::stabilizer).
pub trait Stabilizer<V: Signal> {
    /// One tick: `drive` is what the other side did, `effort` what the port behind answers to it, N.
    fn stabilize(&mut self, drive: &Drive<V>, effort: V) -> Action<V>;
}

impl<V: Signal, S: Stabilizer<V> + ?Sized> Stabilizer<V> for &mut S {
    #[inline(always)]
    fn stabilize(&mut self, drive: &Drive<V>, effort: V) -> Action<V> {
        (**self).stabilize(drive, effort)
    }
}

/// A port with a stabilizer in front: [`OnePort::stabilized`].
#[derive(Clone, Copy, Debug)]
pub struct Stabilized<P, S, V: Signal> {
    port: P,
    stabilizer: S,
    action: Action<V>,
}

impl<P, S, V: Signal> Stabilized<P, S, V> {
    pub(crate) fn new(port: P, stabilizer: S) -> Self {
        Self { port, stabilizer, action: Action::none(V::zero()) }
    }

    /// The port that is watched.
    #[inline(always)]
    pub fn port(&self) -> &P {
        &self.port
    }
}

impl<V: Signal, P: OnePort<V>, S: Stabilizer<V>> OnePort<V> for Stabilized<P, S, V> {
    #[inline(always)]
    fn respond(&mut self, drive: &Drive<V>) -> V {
        let effort = self.port.respond(drive);
        self.action = self.stabilizer.stabilize(drive, effort);
        self.action.effort
    }

    #[inline(always)]
    fn action(&self) -> Action<V> {
        self.action
    }
}
