//! Channels that carry messages from one loop to another.

mod constant_delay;
mod lossy_channel;
mod varying_delay;

pub use constant_delay::ConstantDelay;
pub use lossy_channel::LossyChannel;
pub use varying_delay::VaryingDelay;

/// One direction of a link between two loops that tick together: on every tick a message goes in and the newest that
/// has arrived comes out, again and again until a newer one arrives.
///
/// All lanes of a message travel together.
pub trait Channel<M> {
    /// Takes `message` and returns the newest one that has arrived.
    fn carry(&mut self, message: M) -> M;

    /// A tick whose message is lost on the way: the newest one that has arrived by now.
    fn lose(&mut self) -> M;
}

impl<M, C: Channel<M> + ?Sized> Channel<M> for &mut C {
    fn carry(&mut self, message: M) -> M {
        (**self).carry(message)
    }

    fn lose(&mut self) -> M {
        (**self).lose()
    }
}
