//! Inverted pendulum.

use lyapunov_core::{ParameterError, Requirement, Scalar};
use nalgebra::SVector;

use super::GRAVITY;
use super::trigonometry::sin;
use crate::ControlAffine;

/// A pendulum on a motor, seen from upright: `m l² θ̈ = m g l sin θ − b θ̇ + u`.
///
/// The state is `(θ, θ̇)` in rad and rad/s, `u` a torque in N·m; a point mass `m` at `l` from a joint with viscous
/// friction `b` (Khalil, Nonlinear Systems, 3rd edition, 2002, section 1.2.1, turned over). A feedback
/// `u = −k θ − d θ̇` holds it upright if `k > m g l` and nothing is late.
///
/// ```
/// use lyapunov_plants::{ControlAffine, InvertedPendulum};
/// use nalgebra::Vector2;
/// let pendulum = InvertedPendulum::new(0.5, 0.4, 0.0)?; // kg, m, N·m·s/rad
/// let rates: Vector2<f64> = pendulum.drift(Vector2::new(0.1, 0.0)); // it falls from upright
/// assert!(rates[0] == 0.0 && rates[1] > 0.0);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InvertedPendulum<T> {
    inertia: T,
    weight: T,
    damping: T,
}

impl<T: Scalar> InvertedPendulum<T> {
    /// A pendulum of `mass` kg and `length` m, with a joint's `damping` in N·m·s/rad.
    ///
    /// # Errors
    /// `mass` or `length` not above 0 and finite; `damping` below 0, infinite or NaN; an inertia `m l²` that is out of
    /// the scalar's range.
    pub fn new(mass: T, length: T, damping: T) -> Result<Self, ParameterError> {
        let mass = Requirement::Positive.check("mass", mass)?;
        let length = Requirement::Positive.check("length", length)?;
        let damping = Requirement::NonNegative.check("damping", damping)?;
        let (inertia, weight) = (mass * length * length, mass * T::of(GRAVITY) * length);
        let kept = inertia.finite() & inertia.above(T::of(0.0)) & weight.finite();
        Requirement::InRange.require("mass", mass, kept)?;
        Ok(Self { inertia, weight, damping })
    }

    /// `m l²`, kg·m²: the inertia.
    pub fn inertia(&self) -> T {
        self.inertia
    }

    /// `m g l`, N·m/rad: the least stiffness that holds it upright.
    pub fn weight(&self) -> T {
        self.weight
    }
}

impl<T: Scalar> ControlAffine<T, 2, 1> for InvertedPendulum<T> {
    #[inline]
    fn drift(&self, state: SVector<T, 2>) -> SVector<T, 2> {
        let [angle, rate] = state.data.0[0];
        SVector::from([rate, (self.weight * sin(angle) - self.damping * rate) / self.inertia])
    }

    #[inline]
    fn input_fields(&self, _state: SVector<T, 2>) -> [SVector<T, 2>; 1] {
        [SVector::from([T::of(0.0), T::of(1.0) / self.inertia])]
    }
}
