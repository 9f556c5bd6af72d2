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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::VaryingDelay;

    /// Beside a list that keeps every message with its arrival: a lost one never arrives, and holds no earlier one up.
    #[test]
    fn a_lost_message_never_arrives() {
        let (least, most, loss, seed) = (3_u32, 40_u32, 0.8, 5);
        let delay = VaryingDelay::<_, 64>::new(least, most, seed, 0_u64).unwrap();
        let mut channel = LossyChannel::new(delay, loss, seed).unwrap();
        let mut lag = Random::<f64>::new(|_| seed, Source::Lag);
        let mut losing = Random::<f64>::new(|_| seed, Source::Loss);
        let mut arrives = [u64::MAX; 5000];
        for now in 1..5000_u64 {
            let late = (lag.uniform() * f64::from(most - least + 1)) as u64;
            if losing.uniform() >= loss {
                arrives[now as usize] = now + u64::from(least) + late;
            }
            let newest = (1..=now).rev().find(|sent| arrives[*sent as usize] <= now);
            assert_eq!(channel.carry(now), newest.unwrap_or(0), "{now}");
        }
    }

    #[test]
    fn over_a_line_that_never_delivers_a_tick_takes_no_longer_than_the_line_is_long() {
        let delay = VaryingDelay::<_, 64>::new(3, 40, 1, 0.0).unwrap();
        let mut channel = LossyChannel::new(delay, 1.0, 1).unwrap();
        assert!((0..3_000_000).all(|_| channel.carry(1.0) == 0.0));
    }
}
