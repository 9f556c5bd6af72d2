//! Metric of one weight per axis.

use lyapunov_core::{ParameterError, Requirement, Signal};

use super::Metric;

/// Metric of one weight per axis: `(M v)ᵢ = wᵢ vᵢ`.
///
/// ```
/// use lyapunov_stabilizers::{AxisWeights, Metric};
/// use nalgebra::Vector2;
/// let weights = AxisWeights::new(Vector2::new(1.0, 0.5))?;
/// assert_eq!(weights.apply(Vector2::new(0.2, 0.2)), Vector2::new(0.2, 0.1));
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisWeights<V> {
    weights: V,
}

impl<V: Signal> AxisWeights<V> {
    /// The metric of the axes' `weights`, from 0 to 1; for inertias, each inertia over the largest.
    ///
    /// # Errors
    /// A weight below 0, above 1 or NaN.
    pub fn new(weights: V) -> Result<Self, ParameterError> {
        let weights = Requirement::NonNegative.check_axes("weight", weights)?;
        Ok(Self { weights: Requirement::AtMost(1.0).check_axes("weight", weights)? })
    }

    /// The metric of weights that are known to be from 0 to 1.
    pub(crate) fn of_shares(weights: V) -> Self {
        Self { weights }
    }
}

impl<V: Signal> Metric<V> for AxisWeights<V> {
    #[inline]
    fn apply(&self, velocity: V) -> V {
        velocity.times(self.weights)
    }
}
