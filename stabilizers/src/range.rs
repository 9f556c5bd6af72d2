//! Numbers that follow from a parameter and may leave the range of the scalar.

use lyapunov_core::{ParameterError, Requirement, Scalar};

/// `number`, which follows from the `given` parameter, if it is as `allowed`.
///
/// # Errors
/// The first lane of `given` from which a number follows that is not: the caller has never seen the number itself.
pub(crate) fn in_range<T: Scalar>(
    parameter: &'static str,
    given: T,
    number: T,
    allowed: Requirement,
) -> Result<T, ParameterError> {
    let lost = |&lane: &usize| allowed.check(parameter, number.lane(lane)).is_err();
    match (0..T::LANES).find(lost) {
        None => Ok(number),
        Some(lane) => Err(ParameterError {
            parameter,
            value: given.lane(lane),
            requirement: Requirement::InRange,
        }),
    }
}
