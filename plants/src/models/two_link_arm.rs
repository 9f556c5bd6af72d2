//! Planar arm of two links.

use lyapunov_core::{ParameterError, Requirement, Scalar};
use nalgebra::SVector;

use super::GRAVITY;
use super::trigonometry::{cos, sin};
use crate::ControlAffine;

/// A rigid link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidLink<T> {
    /// Mass, kg.
    pub mass: T,
    /// Length from joint to joint, or to the tip, m.
    pub length: T,
    /// Distance from the joint to the centre of mass, m.
    pub centre: T,
    /// Inertia about the centre of mass, kg·m².
    pub inertia: T,
}

impl<T: Scalar> RigidLink<T> {
    /// A uniform rod of `mass` kg and `length` m.
    pub fn rod(mass: T, length: T) -> Self {
        let inertia = mass * length * length / T::of(12.0);
        Self { mass, length, centre: length * T::of(0.5), inertia }
    }

    /// A rod without mass, of `length` m, with a point of `mass` kg at its end.
    pub fn point(mass: T, length: T) -> Self {
        Self { mass, length, centre: length, inertia: T::of(0.0) }
    }

    pub(super) fn checked(self) -> Result<Self, ParameterError> {
        Requirement::Positive.check("mass", self.mass)?;
        Requirement::Positive.check("length", self.length)?;
        Requirement::Positive.check("centre", self.centre)?;
        Requirement::NonNegative.check("inertia", self.inertia)?;
        Ok(self)
    }
}

/// A planar arm of two links that hangs, without friction: `M(q) q̈ + c(q, q̇) + G(q) = u`.
///
/// ```text
/// M₁₁ = a + 2 b cos q₂     M₁₂ = d + b cos q₂     M₂₂ = d
/// c   = b sin q₂ (−2 q̇₁ q̇₂ − q̇₂², q̇₁²)
/// G   = (w₁ sin q₁ + w₂ sin(q₁ + q₂), w₂ sin(q₁ + q₂))
/// a = I₁ + m₁ c₁² + I₂ + m₂ (l₁² + c₂²),  b = m₂ l₁ c₂,  d = I₂ + m₂ c₂²
/// w₁ = (m₁ c₁ + m₂ l₁) g,  w₂ = m₂ c₂ g
/// ```
///
/// The state is `(q₁, q₂, q̇₁, q̇₂)` in rad and rad/s: `q₁` the angle of the upper link from straight down, `q₂` that
/// of the lower link from the upper one. `u` are the torques in the two joints, N·m (Spong, Hutchinson and Vidyasagar,
/// Robot Modeling and Control, 2006, section 7.3; Murray, Li and Sastry, A Mathematical Introduction to Robotic
/// Manipulation, 1994, section 4.2.3). [`horizontal`](Self::horizontal) leaves gravity out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TwoLinkArm<T> {
    /// `M₁₁`, `M₁₂` and `M₂₂` of the folded arm, `q₂ = π`, kg·m².
    folded: [T; 3],
    /// `b`, kg·m².
    coupling: T,
    /// The determinant of the stretched arm's inertia, kg²·m⁴.
    stretched: T,
    /// `w₁`, `w₂`, N·m.
    pub(super) weights: [T; 2],
}

impl<T: Scalar> TwoLinkArm<T> {
    /// The arm of an `upper` and a `lower` link.
    ///
    /// # Errors
    /// `mass`, `length` or `centre` of a limb not above 0 and finite; its `inertia` below 0, infinite or NaN; limbs so
    /// large or small that the arm's inertia is out of the scalar's range.
    pub fn new(upper: RigidLink<T>, lower: RigidLink<T>) -> Result<Self, ParameterError> {
        let (one, two) = (upper.checked()?, lower.checked()?);
        let coupling = two.mass * one.length * two.centre;
        let second = two.inertia + two.mass * two.centre * two.centre;
        let first = one.inertia + one.mass * one.centre * one.centre;
        let apart = one.length - two.centre;
        // Folded, where the terms with the elbow's angle are 0: a light upper link loses no digits in their difference.
        let folded = [
            first + two.inertia + two.mass * apart * apart,
            two.inertia - two.mass * two.centre * apart,
            second,
        ];
        let gravity = T::of(GRAVITY);
        let weights = [
            (one.mass * one.centre + two.mass * one.length) * gravity,
            two.mass * two.centre * gravity,
        ];
        // Of terms above 0, where M₁₁ M₂₂ − M₁₂² would cancel for a light link.
        let stretched = first * second + two.mass * one.length * one.length * two.inertia;
        let arm = Self { folded, coupling, stretched, weights };
        let least = arm.least_inertia();
        let kept = least.finite() & least.above(T::of(0.0)) & (weights[0] + weights[1]).finite();
        Requirement::InRange.require("mass", one.mass, kept)?;
        Ok(arm)
    }

    /// The same arm in a horizontal plane, without the pull of gravity.
    #[must_use]
    pub fn horizontal(self) -> Self {
        Self { weights: [T::of(0.0); 2], ..self }
    }

    /// The least eigenvalue of `M(q)` over all postures, kg·m²: that of the stretched arm, where the trace is largest
    /// and the determinant smallest. Use it as the mass of a damping limit for both joints.
    pub fn least_inertia(&self) -> T {
        let [m11, m12, m22] = self.inertia(T::of(0.0));
        let trace = m11 + m22;
        let difference = m11 - m22;
        let apart = (difference * difference + T::of(4.0) * m12 * m12).sqrt();
        T::of(2.0) * self.stretched / (trace + apart)
    }

    /// `M₁₁`, `M₁₂` and `M₂₂` at the elbow's angle, by `1 + cos q₂ = 2 cos²(q₂ / 2)`.
    #[inline]
    fn inertia(&self, elbow: T) -> [T; 3] {
        let half = cos(elbow * T::of(0.5));
        let [m11, m12, m22] = self.folded;
        let opened = T::of(2.0) * self.coupling * half * half;
        [m11 + opened + opened, m12 + opened, m22]
    }

    /// The kinetic energy `½ q̇ᵀ M q̇`, J.
    #[inline]
    pub(super) fn kinetic(&self, elbow: T, rates: [T; 2]) -> T {
        let [first, second] = self.momenta(elbow, rates);
        T::of(0.5) * (first * rates[0] + second * rates[1])
    }

    /// The momenta `M q̇`, N·m·s.
    #[inline]
    pub(super) fn momenta(&self, elbow: T, rates: [T; 2]) -> [T; 2] {
        let [m11, m12, m22] = self.inertia(elbow);
        [m11 * rates[0] + m12 * rates[1], m12 * rates[0] + m22 * rates[1]]
    }

    /// The derivative of the kinetic energy with respect to the elbow's angle, N·m.
    #[inline]
    pub(super) fn kinetic_by_elbow(&self, elbow: T, rates: [T; 2]) -> T {
        -(self.coupling * sin(elbow)) * (rates[0] * (rates[0] + rates[1]))
    }

    /// The torques of gravity `G(q)`, N·m.
    #[inline]
    pub(super) fn gravity(&self, angles: [T; 2]) -> [T; 2] {
        let lower = self.weights[1] * sin(angles[0] + angles[1]);
        [self.weights[0] * sin(angles[0]) + lower, lower]
    }

    /// The accelerations `q̈` under `torques` in the joints, N·m.
    #[inline]
    pub(super) fn acceleration(&self, angles: [T; 2], rates: [T; 2], torques: [T; 2]) -> [T; 2] {
        let swing = self.coupling * sin(angles[1]);
        let [first, second] = rates;
        let gravity = self.gravity(angles);
        let driven = [
            torques[0] - gravity[0] + swing * (second * (first + first + second)),
            torques[1] - gravity[1] - swing * (first * first),
        ];
        let [[i11, i12], [_, i22]] = self.inverse(angles[1]);
        [i11 * driven[0] + i12 * driven[1], i12 * driven[0] + i22 * driven[1]]
    }

    /// The inverse of the inertia matrix, `M⁻¹`, of determinant `det M(0) + (b sin q₂)²`.
    #[inline]
    pub(super) fn inverse(&self, elbow: T) -> [[T; 2]; 2] {
        let [m11, m12, m22] = self.inertia(elbow);
        let bent = self.coupling * sin(elbow);
        let determinant = self.stretched + bent * bent;
        let across = -m12 / determinant;
        [[m22 / determinant, across], [across, m11 / determinant]]
    }

    /// The columns of `g(x) = (0, M⁻¹)`.
    #[inline]
    pub(super) fn fields(&self, elbow: T) -> [SVector<T, 4>; 2] {
        let zero = T::of(0.0);
        self.inverse(elbow).map(|[first, second]| SVector::from([zero, zero, first, second]))
    }
}

impl<T: Scalar> ControlAffine<T, 4, 2> for TwoLinkArm<T> {
    #[inline]
    fn drift(&self, state: SVector<T, 4>) -> SVector<T, 4> {
        let [shoulder, elbow, first, second] = state.data.0[0];
        let none = [T::of(0.0); 2];
        let [a, b] = self.acceleration([shoulder, elbow], [first, second], none);
        SVector::from([first, second, a, b])
    }

    #[inline]
    fn input_fields(&self, state: SVector<T, 4>) -> [SVector<T, 4>; 2] {
        self.fields(state[1])
    }
}
