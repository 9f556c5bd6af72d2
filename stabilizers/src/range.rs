//! Numbers that follow from a parameter and may leave the range of the scalar.

use lyapunov_core::{ParameterError, Requirement, Scalar};

/// `number`, which follows from the `given` parameter, if it is finite and above 0.
pub(crate) fn in_range<T: Scalar>(
    parameter: &'static str,
    given: T,
    number: T,
) -> Result<T, ParameterError> {
    let kept = number.finite() & number.above(T::of(0.0));
    Requirement::InRange.require(parameter, given, kept).map(|()| number)
}
