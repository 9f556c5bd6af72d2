//! Slave behind a wave.

use lyapunov_core::{ParameterError, Requirement, Scalar, Signal};

use super::WaveTransform;

/// A slave's controller, a spring `K` (N/m) and a damper `B` (N·s/m), driven by a wave: it solves for the flow that it
/// is commanded.
///
/// ```text
/// v = (√(2 b) u + B v_s − K e) / (b + B),   F = B (v − v_s) + K e,   w = (b v − F) / √(2 b)
/// ```
///
/// `e` is the error of the spring (commanded position minus the slave's), `v_s` the slave's own velocity and `F` the
/// force on the slave. With `B = b` it is **matched**: at rest and without error nothing comes back, `w = 0`; every
/// other `B` reflects a share `(b − B) / (b + B)` of the wave. Derived here from the transform; impedance matching is
/// due to Niemeyer and Slotine (International Journal of Robotics Research 23(9), 2004). Passive as the transform is,
/// for `K, B ≥ 0`.
///
/// ```
/// use lyapunov_stabilizers::{WaveFollower, WaveTransform};
/// let follower = WaveFollower::matched(WaveTransform::new(2.0)?, 50.0)?;
/// let following = follower.follow(1.0, 0.0, 0.0);
/// assert_eq!((following.flow, following.effort, following.back), (0.5, 1.0, 0.0));
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WaveFollower<T> {
    wave: WaveTransform<T>,
    stiffness: T,
    damping: T,
}

/// Motion, effort and returned wave of a [`WaveFollower`] on one tick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Following<V> {
    /// The commanded flow `v`, m/s.
    pub flow: V,
    /// The force `F` on the slave, N.
    pub effort: V,
    /// The wave `w` to send back, √W.
    pub back: V,
}

impl<T: Scalar> WaveFollower<T> {
    /// A controller of `stiffness` N/m and `damping` N·s/m behind `wave`.
    ///
    /// # Errors
    /// `stiffness` or `damping` below 0, infinite or NaN.
    pub fn new(wave: WaveTransform<T>, stiffness: T, damping: T) -> Result<Self, ParameterError> {
        let stiffness = Requirement::NonNegative.check("follower stiffness", stiffness)?;
        let damping = Requirement::NonNegative.check("follower damping", damping)?;
        Ok(Self { wave, stiffness, damping })
    }

    /// The controller of `stiffness` whose damping is the wave impedance.
    ///
    /// # Errors
    /// `stiffness` below 0, infinite or NaN.
    pub fn matched(wave: WaveTransform<T>, stiffness: T) -> Result<Self, ParameterError> {
        Self::new(wave, stiffness, wave.impedance)
    }

    /// The answer to the wave `there`, √W, at the spring's `error`, m, and the slave's `velocity`, m/s.
    #[inline]
    pub fn follow<V: Signal<Scalar = T>>(&self, there: V, error: V, velocity: V) -> Following<V> {
        let sprung = error.scale(self.stiffness);
        let pulled = there.scale(self.wave.root) + velocity.scale(self.damping) - sprung;
        let share = self.wave.impedance + self.damping;
        let flow = pulled.map(|it| it / share);
        let effort = (flow - velocity).scale(self.damping) + sprung;
        let back = (flow.scale(self.wave.impedance) - effort).map(|it| it / self.wave.root);
        Following { flow, effort, back }
    }
}
