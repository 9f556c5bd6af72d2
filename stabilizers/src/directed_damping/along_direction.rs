//! Metric of one direction.

use lyapunov_core::{ParameterError, Requirement, Signal, length_and_direction};

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
    /// A length that is not above 0 and finite.
    pub fn new(direction: V) -> Result<Self, ParameterError> {
        // The length, scaled by the largest axis, misses a NaN on one axis.
        Requirement::Finite.check_axes("direction", direction)?;
        let (length, _) = length_and_direction(direction, V::zero());
        Requirement::Positive.check("direction's length", length)?;
        Ok(Self { direction: direction.map(|axis| axis / length) })
    }
}

impl<V: Signal> Metric<V> for AlongDirection<V> {
    #[inline]
    fn apply(&self, velocity: V) -> V {
        self.direction.scale(self.direction.inner(velocity))
    }
}
