//! The loop of the page's map, in a crate of its own: a crate is compiled either for size or for speed.

use lyapunov::ParameterError;
use lyapunov_lab::map::{BasicName, Kernel};
use lyapunov_lab::{Verdict, Yardstick};

/// The verdict on the run of each of `cells` under `name`, and the quantity that it is judged by.
///
/// # Errors
/// A parameter out of the range of the scalar.
pub fn verdicts(
    kernel: &Kernel,
    name: BasicName,
    cells: &[u64],
) -> Result<Vec<(Verdict, Yardstick)>, ParameterError> {
    kernel.verdicts_in_f64(name, cells)
}
