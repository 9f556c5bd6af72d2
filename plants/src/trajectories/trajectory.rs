//! `Trajectory` trait: a value that follows time.

use lyapunov_core::Signal;

/// A value that follows time in ticks of the servo rate, `t_n = n / servo_rate`.
///
/// The trajectories of this crate are computed in `f64` and rounded to the scalar once, alike in every lane. Every
/// `Fn(u64) -> V` is a trajectory; pass one in a box or behind a reference as `|tick| trajectory.at(tick)`.
///
/// ```
/// use lyapunov_plants::{Trajectory, Step};
/// let step = Step::new(0.0, 0.02, 0.5, 1000.0)?;
/// let at = |tick| -> f64 { step.at(tick) };
/// assert_eq!([499, 500].map(at), [0.0, 0.02]);
/// let there_and_back = |tick| at(tick) - at(tick / 2);
/// assert_eq!([600, 1000].map(|tick| there_and_back.at(tick)), [0.02, 0.0]);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
pub trait Trajectory<V: Signal> {
    /// The value from `tick` to the next.
    fn at(&self, tick: u64) -> V;
}

impl<V: Signal, F: Fn(u64) -> V> Trajectory<V> for F {
    #[inline]
    fn at(&self, tick: u64) -> V {
        self(tick)
    }
}
