//! Wave variables.

mod follower;
mod wave_filter;

pub use follower::{Following, WaveFollower};
pub use wave_filter::WaveFilter;

use lyapunov_core::{ParameterError, Requirement, Scalar, Signal};

use crate::range::in_range;

/// The wave transformation with the impedance `b`, N·s/m: `u = (b v + F) / √(2b)`, `w = (b v − F) / √(2b)`.
///
/// `u` travels with the flow and `w` comes back, and the power is `F v = (u² − w²) / 2`: what a wave carries it carries
/// by itself, in √W. A channel that only delays waves, equally long each, has stored `∫ (u² + w²) / 2 ≥ 0` over what is
/// under way, and is passive for whatever delay (Niemeyer and Slotine, IEEE Journal of Oceanic Engineering 16(1), 1991;
/// this code's form as in public code that implements it). A delay that varies stretches and squeezes waves, and a lost
/// wave that is replaced by the one before is carried twice: neither is passive by itself. All of this holds for
/// the power `F v` at the ticks; the work `F Δx` of a held effort differs from it by `F (Δx − v T)`, which is not bounded.
///
/// At one end the flow is known and the wave that came in, at the other the effort: [`effort`](Self::effort) and
/// [`flow`](Self::flow) give what is not. An end that answers its wave with `F = b v` sends none back; any other
/// reflects. A [`WaveFollower`] is a slave that is matched so, and a [`WaveFilter`] takes what is fast out of the
/// waves.
///
/// ```
/// use lyapunov_stabilizers::WaveTransform;
/// let wave = WaveTransform::new(2.0)?;
/// let (there, back) = wave.encode(0.5, 3.0);
/// assert_eq!((there, back), (2.0, -1.0)); // (4 − 1) / 2 = 3 · 0.5 W
/// assert_eq!(wave.decode(there, back), (0.5, 3.0));
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WaveTransform<T> {
    impedance: T,
    root: T,
}

impl<T: Scalar> WaveTransform<T> {
    /// The transformation of `impedance` N·s/m.
    ///
    /// # Errors
    /// `impedance` not above 0 and finite, or so large that twice it is out of range.
    pub fn new(impedance: T) -> Result<Self, ParameterError> {
        let impedance = Requirement::Positive.check("wave impedance", impedance)?;
        let root = in_range("wave impedance", impedance, (impedance + impedance).sqrt())?;
        Ok(Self { impedance, root })
    }

    /// The waves there and back of a flow and an effort, √W.
    #[inline]
    pub fn encode<V: Signal<Scalar = T>>(&self, flow: V, effort: V) -> (V, V) {
        let driven = flow.scale(self.impedance);
        ((driven + effort).map(|it| it / self.root), (driven - effort).map(|it| it / self.root))
    }

    /// The flow (m/s) and the effort (N) of the waves `there` and `back`.
    #[inline]
    pub fn decode<V: Signal<Scalar = T>>(&self, there: V, back: V) -> (V, V) {
        // The root that the waves were divided by, so that its rounding cancels.
        let half = self.root * T::of(0.5);
        ((there + back).map(|it| it * half / self.impedance), (there - back).scale(half))
    }

    /// The effort where `flow` is known and the wave `back` came in, and the wave that goes `there`.
    #[inline]
    pub fn effort<V: Signal<Scalar = T>>(&self, flow: V, back: V) -> (V, V) {
        let there = flow.scale(self.root) - back;
        (flow.scale(self.impedance) - back.scale(self.root), there)
    }

    /// The flow where `effort` is known and the wave `there` came in, and the wave that goes `back`.
    #[inline]
    pub fn flow<V: Signal<Scalar = T>>(&self, effort: V, there: V) -> (V, V) {
        let flow = (there.scale(self.root) - effort).map(|it| it / self.impedance);
        (flow, flow.scale(self.root) - there)
    }
}
