//! One scalar constraint on an input.

use lyapunov_core::{ParameterError, Requirement, Scalar, Signal};

use crate::hypotenuse::hypotenuse;

/// The constraint `a + b · u ≤ 0` on an input `u`: of a control Lyapunov function `V` with `ẋ = f + g u`,
/// `a = L_f V + …` is the drift and `b = L_g V` the gain.
///
/// What a quadratic program gives for one such constraint has a closed form, and so has Sontag's universal formula
/// (Sontag, Systems and Control Letters 13, 1989; the least norm after Freeman and Kokotović, Robust Nonlinear Control
/// Design, 1996). An [`Input`] says where there is none: `b = 0` while `a > 0`. A `b` whose square is too small for the scalar counts
/// as 0.
///
/// ```
/// use lyapunov_stabilizers::Constraint;
/// let constraint = Constraint { drift: 3.0_f64, gain: 2.0 };
/// assert_eq!(constraint.least_norm().input, -1.5);
/// assert_eq!(constraint.sontag().input, -4.0);
/// let idle: Constraint<f64> = Constraint { drift: 3.0, gain: 0.0 };
/// assert!(!idle.least_norm().feasible);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constraint<V: Signal> {
    /// `a`.
    pub drift: V::Scalar,
    /// `b`.
    pub gain: V,
}

/// An input for a [`Constraint`], and whether it meets it.
#[derive(Clone, Copy, Debug)]
pub struct Input<V: Signal> {
    /// The input; where none meets the constraint, the one that does not try.
    pub input: V,
    /// Lanes in which some input meets the constraint; none where a number that it is made of is infinite or NaN.
    pub feasible: <V::Scalar as Scalar>::Mask,
}

impl<V: Signal> Constraint<V> {
    /// The least input that meets it: `u = −max(a, 0) b / (b · b)`.
    #[inline]
    pub fn least_norm(&self) -> Input<V> {
        self.nearest(V::zero(), |gain| gain)
    }

    /// Sontag's input: `u = −(a + √(a² + (b · b)²)) b / (b · b)`, and 0 at `b = 0`. It meets the constraint with a
    /// margin that grows with `|a|` and `|b|`, and is smooth where `V` is.
    #[inline]
    pub fn sontag(&self) -> Input<V> {
        let zero = V::Scalar::of(0.0);
        let square = self.gain.inner(self.gain);
        let root = hypotenuse(self.drift, square);
        // `(a + √…) / b²` without cancelling digits where `a < 0`.
        let (positive, negative) = ((self.drift + root) / square, square / (root - self.drift));
        let rate = V::Scalar::choose(self.drift.above(zero), positive, negative);
        self.met(self.gain.scale(-rate), V::zero(), square)
    }

    /// The input nearest to `wished`, `u = w − max(0, a + b · w) R⁻¹ b / (b · R⁻¹ b)`, in the norm of the weights `R`
    /// of the axes.
    ///
    /// # Errors
    /// A weight not above 0 and finite.
    #[inline]
    pub fn filter(&self, wished: V, weights: V) -> Result<Input<V>, ParameterError> {
        let weights = Requirement::Positive.check_axes("input's weight", weights)?;
        Ok(self.nearest(wished, |gain| gain.zip(weights, |b, weight| b / weight)))
    }

    #[inline(always)]
    fn nearest(&self, wished: V, metric: impl Fn(V) -> V) -> Input<V> {
        let direction = metric(self.gain);
        let square = self.gain.inner(direction);
        let lacking = (self.drift + self.gain.inner(wished)).larger(V::Scalar::of(0.0));
        self.met(wished - direction.scale(lacking / square), wished, square)
    }

    /// `input` where something can be done, `otherwise` elsewhere.
    #[inline(always)]
    fn met(&self, input: V, otherwise: V, square: V::Scalar) -> Input<V> {
        let zero = V::Scalar::of(0.0);
        let able = square.above(zero) & input.finite();
        let met = able | !self.drift.above(zero);
        let known = (self.drift + square).finite() & otherwise.finite();
        Input { input: V::choose(able, input, otherwise), feasible: met & known }
    }
}
