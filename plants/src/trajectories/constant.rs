//! Constant value.

use lyapunov_core::{ParameterError, Requirement, Scalar};

use crate::Trajectory;

/// The same value at every tick; as an external force, a load.
///
/// ```
/// use lyapunov_plants::{Constant, Trajectory};
/// let load: f64 = Constant::new(2.0)?.at(123);
/// assert_eq!(load, 2.0);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
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
