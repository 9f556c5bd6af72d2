//! Total decrease of a Lyapunov function of the state, as a candidate.

use lyapunov_core::{LyapunovFunction, Scalar, StorageFunction};
use nalgebra::SVector;

use crate::WithState;

/// The candidate that sums the total decrease of `function` from `state` on, `L(n) = V(x(0)) − V(x(n))`, by its
/// differences.
///
/// It counts what the drift feeds or dissipates as well as the work of the input, needs neither `f` nor an integral,
/// and is exact whatever is held, delayed or clipped in between. `L ≥ 0` means that `V` is not above its initial value.
///
/// ```
/// use lyapunov_core::Stabilizer;
/// use lyapunov_plants::{QuadraticForm, decrease_of};
/// use nalgebra::Vector2;
/// let candidate = decrease_of(QuadraticForm::sum_of_squares(), Vector2::new(0.5, 0.0));
/// # let _: lyapunov_core::StorageFunction<_, f64> = candidate;
/// # fn used<const M: usize>(c: impl lyapunov_core::LyapunovCandidate<lyapunov_plants::WithState<f64, 2, M>>) {}
/// # used::<1>(candidate);
/// ```
pub fn decrease_of<T, F, const N: usize, const M: usize>(
    function: F,
    state: SVector<T, N>,
) -> StorageFunction<impl Fn(WithState<T, N, M>, WithState<T, N, M>) -> T + Copy, T>
where
    T: Scalar,
    F: LyapunovFunction<SVector<T, N>> + Copy,
{
    let value = move |at: WithState<T, N, M>, _| function.value(at.state);
    let start = WithState { input: SVector::zeros(), state };
    StorageFunction::starting(value, start, start)
}
