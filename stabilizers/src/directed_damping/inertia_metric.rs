//! Metric of an inertia matrix.

use lyapunov_core::{ParameterError, Requirement, Scalar};
use nalgebra::{SMatrix, SVector};

use super::Metric;
use crate::factors::Factors;

/// Metric of an inertia matrix: `M v = Λ v / ‖Λ‖`, with `‖Λ‖` the largest absolute row sum, an upper bound of every
/// eigenvalue.
///
/// A correction `β Λ v / ‖Λ‖` takes the same share of the speed in every direction, however coupled the axes are: `Λ v`
/// is the momentum. At the tip of an arm `Λ = (J A⁻¹ Jᵀ)⁻¹`, with `A` the inertia of its joints (Khatib 1987). Ott,
/// Artigas and Preusche (2011) distribute the dissipation of a passivity controller over directions.
///
/// ```
/// use lyapunov_stabilizers::{InertiaMetric, Metric};
/// use nalgebra::{Matrix2, Vector2};
/// let metric = InertiaMetric::new(Matrix2::new(3.0, 1.0, 1.0, 1.0))?;
/// assert_eq!(metric.apply(Vector2::new(1.0, -1.0)), Vector2::new(0.5, 0.0));
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InertiaMetric<T, const N: usize> {
    share: SMatrix<T, N, N>,
    norm: T,
}

impl<T: Scalar, const N: usize> InertiaMetric<T, N> {
    /// The metric of the matrix `Λ`, kg or kg·m²; only its lower triangle is read.
    ///
    /// # Errors
    /// A matrix that is not positive definite, not finite, or so near to either that its digits do not decide: a pivot
    /// `dᵢ` of `Λ = L D Lᵀ` that is not above 0.
    pub fn new(inertia: SMatrix<T, N, N>) -> Result<Self, ParameterError> {
        let whole = Factors::whole(inertia);
        let mut norm = T::of(0.0);
        for row in 0..N {
            let sum = (0..N).fold(T::of(0.0), |sum, column| sum + whole[(row, column)].magnitude());
            norm = norm.larger(Requirement::Positive.check("inertia's row", sum)?);
        }
        let share = whole.map(|entry: T| entry / norm);
        Factors::of(share, "inertia's pivot")?;
        Ok(Self { share, norm })
    }

    /// `‖Λ‖`, kg or kg·m²: the mass for the [`DampingLimit`](crate::DampingLimit) of
    /// [`DirectedDamping`](super::DirectedDamping), as `cap ‖Λ‖ / T` takes the share `cap` of the speed in a tick in
    /// every direction.
    pub fn norm(&self) -> T {
        self.norm
    }
}

impl<T: Scalar, const N: usize> Metric<SVector<T, N>> for InertiaMetric<T, N> {
    #[inline]
    fn apply(&self, velocity: SVector<T, N>) -> SVector<T, N> {
        SVector::from_fn(|row, _| {
            (0..N)
                .fold(T::of(0.0), |sum, column| sum + self.share[(row, column)] * velocity[column])
        })
    }
}
