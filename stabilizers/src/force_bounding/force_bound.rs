//! Force bounding that keeps what free motion dissipated.

use lyapunov_core::{ParameterError, Plain, Scalar};

use super::{EveryAxis, ForceBounding, KeptCredit};

/// Force bounding without its reset: `|F(n)| ≤ √(4 b E(n) / T)`, `E(n) = E₀ + Σ (f_act(n−1) · Δx(n) + b |Δx(n)|² / T)`.
///
/// Derived here as the largest force that keeps `E` at or above 0 ([`ForceBounding`] says why), it is the published law
/// but for the reset: `E` starts at a budget `E₀` ([`budgeted`](ForceBounding::budgeted)), and what a long free motion
/// dissipated allows a burst later, for which see [`StabilizerExt::bounded`](crate::StabilizerExt::bounded) and
/// [`StabilizerExt::reset_at`](crate::StabilizerExt::reset_at).
///
/// ```
/// use lyapunov_core::{PortSample, Stabilizer};
/// use lyapunov_stabilizers::ForceBound;
/// let mut bound = ForceBound::new(0.1)?.budgeted(1e-3)?; // N·s/m, J
/// let correction = bound.stabilize(&PortSample::starting(1e-3, 0.0, 0.0), 5.0);
/// assert!((correction.effort - 0.4_f64.sqrt()).abs() < 1e-12); // √(4 · 0.1 · 1e-3 / 1e-3) N
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
pub type ForceBound<T, A = Plain<T>> = ForceBounding<T, EveryAxis<T>, KeptCredit, A>;

impl<T: Scalar> ForceBound<T> {
    /// A bound for a device that surely has the viscous `damping`, N·s/m.
    ///
    /// # Errors
    /// `damping` below 0, infinite or NaN.
    pub fn new(damping: T) -> Result<Self, ParameterError> {
        Self::over(EveryAxis::new(damping)?)
    }
}
