//! Trajectory along the first axis.

use lyapunov_core::Signal;

use crate::Trajectory;

/// A trajectory of one number on the first axis of a signal, with given values on the others: a load in +x, a hand that
/// moves along x only.
///
/// ```
/// use lyapunov_plants::{Trajectory, FirstAxis, Pulse};
/// use nalgebra::Vector2;
/// let pulse = Pulse::new(3.0, 0.0, 0.1, 1000.0)?;
/// assert_eq!(FirstAxis::of(pulse, Vector2::new(0.0, 7.0)).at(5), Vector2::new(3.0, 7.0));
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FirstAxis<C, V> {
    trajectory: C,
    others: V,
}

impl<C, V> FirstAxis<C, V> {
    /// `trajectory` on the first axis and `others` on all others.
    pub fn of(trajectory: C, others: V) -> Self {
        Self { trajectory, others }
    }
}

impl<V: Signal, C: Trajectory<V::Scalar>> Trajectory<V> for FirstAxis<C, V> {
    #[inline]
    fn at(&self, tick: u64) -> V {
        let mut first = Some(self.trajectory.at(tick));
        self.others.map(|other| first.take().unwrap_or(other))
    }
}
