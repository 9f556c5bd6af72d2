//! Van der Pol oscillator.

use lyapunov_core::{ParameterError, Requirement, Scalar};
use nalgebra::SVector;

use crate::ControlAffine;

/// The Van der Pol oscillator with an input: `ẍ − μ (1 − x²) ẋ + x = u`, all without units.
///
/// The state is `(x, ẋ)`. Its damping is negative where `|x| < 1`: every start except rest leads to one limit cycle, of
/// amplitude 2 for small `μ` and near 2 for any (van der Pol, On relaxation oscillations, Philosophical Magazine 2,
/// 1926; Khalil, Nonlinear Systems, 3rd edition, 2002, section 2.4). With `V = ½ (x² + ẋ²)` the flow is `ẋ`, the
/// apparent mass 1, and `V̇ = μ (1 − x²) ẋ² + ẋ u`.
///
/// ```
/// use lyapunov_plants::{ControlAffine, VanDerPol};
/// use nalgebra::Vector2;
/// let oscillator = VanDerPol::new(1.0)?;
/// let rates: Vector2<f64> = oscillator.drift(Vector2::new(0.0, 1.0)); // near 0 it is driven outwards
/// assert_eq!(rates, Vector2::new(1.0, 1.0));
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VanDerPol<T> {
    mu: T,
}

impl<T: Scalar> VanDerPol<T> {
    /// The oscillator with the parameter `mu`.
    ///
    /// # Errors
    /// `mu` below 0, infinite or NaN.
    pub fn new(mu: T) -> Result<Self, ParameterError> {
        Ok(Self { mu: Requirement::NonNegative.check("mu", mu)? })
    }
}

impl<T: Scalar> ControlAffine<T, 2, 1> for VanDerPol<T> {
    #[inline]
    fn drift(&self, state: SVector<T, 2>) -> SVector<T, 2> {
        let [x, rate] = state.data.0[0];
        SVector::from([rate, self.mu * (T::of(1.0) - x * x) * rate - x])
    }

    #[inline]
    fn input_fields(&self, _state: SVector<T, 2>) -> [SVector<T, 2>; 1] {
        [SVector::from([T::of(0.0), T::of(1.0)])]
    }
}
