//! Varying delay of a channel.

use lyapunov_core::{ParameterError, Requirement};

use super::Channel;
use crate::{Random, Source};

/// A message under way.
#[derive(Clone, Copy, Debug)]
struct Letter<M> {
    message: M,
    arrives: u64,
}

/// A channel that delays each message by its own number of ticks, uniform from `least` to `most`, which is below `N`.
///
/// Messages overtake one another; one that is older than what has already arrived is discarded.
///
/// ```
/// use lyapunov_plants::{Channel, VaryingDelay};
/// let mut channel = VaryingDelay::<_, 8>::new(1, 5, 7, 0)?;
/// let arrived: Vec<i32> = (1..100).map(|message| channel.carry(message)).collect();
/// assert!(arrived.windows(2).all(|pair| pair[0] <= pair[1])); // never back in time
/// assert!(arrived.iter().zip(1..).all(|(then, now)| (1..=5).contains(&(now - then)) || *then == 0));
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct VaryingDelay<M, const N: usize> {
    least: u64,
    choices: f64,
    random: Random<f64>,
    tick: u64,
    arrived: M,
    newest: u64,
    letters: [Letter<M>; N],
}

impl<M: Copy, const N: usize> VaryingDelay<M, N> {
    /// Delays from `least` to `most` ticks; until the first message arrives, the channel gives `before`.
    ///
    /// # Errors
    /// `least` above `most`, or `most` not below `N`.
    pub fn new(least: u32, most: u32, seed: u64, before: M) -> Result<Self, ParameterError> {
        Requirement::AtMost(most.into()).check("least channel ticks", f64::from(least))?;
        Requirement::AtMost(N as f64 - 1.0).check("most channel ticks", f64::from(most))?;
        Ok(Self {
            least: least.into(),
            choices: f64::from(most - least) + 1.0,
            random: Random::new(|_| seed, Source::Lag),
            tick: 0,
            arrived: before,
            newest: 0,
            letters: [Letter { message: before, arrives: 0 }; N],
        })
    }
}

impl<M: Copy, const N: usize> Channel<M> for VaryingDelay<M, N> {
    fn carry(&mut self, message: M) -> M {
        self.send(Some(message))
    }

    fn lose(&mut self) -> M {
        self.send(None)
    }
}

impl<M: Copy, const N: usize> VaryingDelay<M, N> {
    /// Sends a message, or one that never arrives, and returns the newest one that has arrived.
    fn send(&mut self, message: Option<M>) -> M {
        self.tick = self.tick.wrapping_add(1);
        let now = self.tick;
        // Drawn for a lost message too: the random numbers stay those of their tick.
        let lag = self.least + (self.random.uniform() * self.choices) as u64;
        let slot = |sent: u64| (sent % N as u64) as usize;
        // A letter is under way for N − 1 ticks at most, so the overwritten one has arrived or is lost.
        if let Some(free) = self.letters.get_mut(slot(now)) {
            *free = match message {
                Some(message) => Letter { message, arrives: now.wrapping_add(lag) },
                None => Letter { arrives: u64::MAX, ..*free },
            };
        }
        // Only letters sent after the newest arrival, long enough ago, and not yet overwritten can arrive.
        let first = self.newest.wrapping_add(1).max(now.saturating_sub(N as u64 - 1));
        for sent in (first..=now.saturating_sub(self.least)).rev() {
            if let Some(letter) = self.letters.get(slot(sent))
                && letter.arrives <= now
            {
                (self.arrived, self.newest) = (letter.message, sent);
                break;
            }
        }
        self.arrived
    }
}
