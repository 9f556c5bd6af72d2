//! What carries messages from one loop to another.

mod constant_delay;
mod lossy_channel;
mod varying_delay;

pub use constant_delay::ConstantDelay;
pub use lossy_channel::LossyChannel;
pub use varying_delay::VaryingDelay;

/// One direction of a link between two loops that tick together: a message goes in on every tick, and the newest that
/// has arrived comes out, the same again where there is none.
///
/// All lanes of a message travel together.
pub trait Channel<M> {
    /// Takes `message` and gives the newest one that has arrived.
    fn carry(&mut self, message: M) -> M;
}

impl<M, C: Channel<M> + ?Sized> Channel<M> for &mut C {
    fn carry(&mut self, message: M) -> M {
        (**self).carry(message)
    }
}
