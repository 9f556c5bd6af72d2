//! Loss of messages on a channel.

use lyapunov_core::{ParameterError, Requirement};

use super::Channel;
use crate::{Random, Source};

/// A channel that loses each message with a given probability, independently of the others: what has arrived before stays
/// until a later message arrives.
///
/// ```
/// use lyapunov_plants::{Channel, ConstantDelay, LossyChannel};
/// let mut channel = LossyChannel::new(ConstantDelay::<_, 4>::new(1, 0.0)?, 1.0, 7)?;
/// assert_eq!([1.0, 2.0, 3.0].map(|message| channel.carry(message)), [0.0; 3]);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct LossyChannel<C> {
    channel: C,
    probability: f64,
    random: Random<f64>,
}

impl<C> LossyChannel<C> {
    /// `channel`, losing messages with `probability`.
    ///
    /// # Errors
    /// `probability` not from 0 to 1.
    pub fn new(channel: C, probability: f64, seed: u64) -> Result<Self, ParameterError> {
        Requirement::NonNegative.check("loss probability", probability)?;
        Requirement::AtMost(1.0).check("loss probability", probability)?;
        let random = Random::new(|_| seed, Source::Loss);
        Ok(Self { channel, probability, random })
    }
}

impl<M, C: Channel<M>> Channel<M> for LossyChannel<C> {
    fn carry(&mut self, message: M) -> M {
        if self.random.chance(self.probability) {
            self.channel.lose()
        } else {
            self.channel.carry(message)
        }
    }

    fn lose(&mut self) -> M {
        // The random numbers stay those of their tick.
        let _ = self.random.chance(self.probability);
        self.channel.lose()
    }
}
