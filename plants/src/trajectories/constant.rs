//! Constant value.

use lyapunov_core::{ParameterError, Requirement, Scalar};

use crate::Trajectory;

/// The same value at every tick; as an external force, a load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constant {
    value: f64,
}

impl Constant {
    /// `value` from the start.
    ///
    /// # Errors
    /// A value that is infinite or NaN.
    pub fn new(value: f64) -> Result<Self, ParameterError> {
        Ok(Self { value: Requirement::Finite.check("value", value)? })
    }
}

impl<T: Scalar> Trajectory<T> for Constant {
    #[inline]
    fn at(&self, _tick: u64) -> T {
        T::of(self.value)
    }
}
