//! Metric of one direction.

use lyapunov_core::{ParameterError, Requirement, Signal, largest_axis, length_and_direction};

use super::Metric;

/// Metric of one direction `d` of length 1: `M v = d (d · v)`.
///
/// ```
/// use lyapunov_stabilizers::{AlongDirection, Metric};
/// use nalgebra::Vector2;
/// let normal = AlongDirection::new(Vector2::new(0.0, 2.0))?; // of any length
/// assert_eq!(normal.apply(Vector2::new(0.3, 0.1)), Vector2::new(0.0, 0.1));
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AlongDirection<V> {
    direction: V,
}

impl<V: Signal> AlongDirection<V> {
    /// The metric of the direction of `direction`, which may have any length but 0.
    ///
    /// # Errors
    /// An axis that is not finite; all axes 0.
    pub fn new(direction: V) -> Result<Self, ParameterError> {
        Requirement::Finite.check_axes("direction", direction)?;
        // By the largest axis: the length may be out of range where the direction is not.
        Requirement::Positive.check("direction's length", largest_axis(direction))?;
        let (_, direction) = length_and_direction(direction, V::zero());
        Ok(Self { direction })
    }
}

impl<V: Signal> Metric<V> for AlongDirection<V> {
    #[inline]
    fn apply(&self, velocity: V) -> V {
        self.direction.scale(self.direction.inner(velocity))
    }
}
