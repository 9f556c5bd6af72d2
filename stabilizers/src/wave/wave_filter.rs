//! Filter of waves.

use lyapunov_core::{ParameterError, Requirement, Scalar, Signal, Snapshot};

/// A low pass in the path of a wave: `s += a (u − s)`, `0 < a ≤ 1`, in √W; `s` is sent.
///
/// **Guarantee** (after Niemeyer and Slotine; derived here): its gain is at most 1 at all frequencies, so that
/// `Σ s² ≤ Σ u²` from `s = 0` on, and a passive channel stays passive with it. What it takes off the waves is position,
/// too: send the integral of `u` beside it, or correct within the surplus `Σ (u² − s²) / 2`. For a lost wave pass 0.
///
/// A wave that is not finite is passed over.
///
/// ```
/// use lyapunov_stabilizers::WaveFilter;
/// let mut filter = WaveFilter::new(0.25)?;
/// assert_eq!([1.0, 1.0, 0.0].map(|wave| filter.pass(wave)), [0.25, 0.4375, 0.328125]);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WaveFilter<V: Signal> {
    share: V::Scalar,
    sent: V,
}

impl<V: Signal> WaveFilter<V> {
    /// A filter that takes over `share` a of a change on each tick; 1 passes waves as they are, bit for bit.
    ///
    /// # Errors
    /// `share` not above 0, or above 1.
    pub fn new(share: V::Scalar) -> Result<Self, ParameterError> {
        let share = Requirement::Positive.check("wave filter share", share)?;
        let share = Requirement::AtMost(1.0).check("wave filter share", share)?;
        Ok(Self { share, sent: V::zero() })
    }

    /// The wave to send for `wave`.
    #[inline]
    pub fn pass(&mut self, wave: V) -> V {
        // A share of both, so that a share of 1 passes each bit.
        let kept = V::Scalar::of(1.0) - self.share;
        let sent = wave.scale(self.share) + self.sent.scale(kept);
        self.sent = V::choose(sent.finite(), sent, self.sent);
        self.sent
    }
}

impl<V: Signal> Snapshot for WaveFilter<V> {
    /// The last wave that was sent, √W.
    type State = V;

    fn state(&self) -> V {
        self.sent
    }

    fn restored(self, sent: V) -> Result<Self, ParameterError> {
        Ok(Self { sent: Requirement::Finite.check_axes("stored wave", sent)?, ..self })
    }
}
