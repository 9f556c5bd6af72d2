//! Twist or wrench of a rigid body.

use core::marker::PhantomData;

use nalgebra::Vector3;
use num_traits::Zero;

use crate::{Angle, Axes, Pose, Scalar, WorldAxes};

/// A twist or a wrench along given axes ([`WorldAxes`] or [`BodyAxes`](crate::BodyAxes)), at the body's reference point.
///
/// | | `translation` | `rotation` |
/// |---|---|---|
/// | velocity | m/s | rad/s |
/// | displacement | m | rad |
/// | effort | N | N·m |
/// | work | J | J |
///
/// Wrench paired with twist is power in any axes, `f·v + τ·ω`, and that is what [`Signal::inner`](crate::Signal::inner) gives; axes of
/// different kinds do not mix. The product of a twist with itself has no unit: whatever weighs translation against
/// rotation (a damping, a limit) comes in two numbers.
///
/// ```
/// use approx::assert_abs_diff_eq;
/// use lyapunov_core::{BodyAxes, Pose, Screw, Signal, WorldAxes};
/// use nalgebra::{Isometry3, Vector3};
/// let start = Pose::from(Isometry3::translation(0.1, 0.0, 0.0));
/// let end = Pose::from(Isometry3::new(Vector3::new(0.1, 0.02, 0.0), Vector3::new(0.0, 0.0, 0.3)));
/// let moved = Screw::<f64, WorldAxes>::between(&start, &end);
/// assert_abs_diff_eq!(moved.translation.y, 0.02, epsilon = 1e-15);
/// assert_abs_diff_eq!(moved.rotation.z, 0.3, epsilon = 1e-15);
/// let held = Screw::new(Vector3::new(0.0, 5.0, 0.0), Vector3::new(0.0, 0.0, 2.0)); // 5 N and 2 N·m
/// assert_abs_diff_eq!(held.inner(moved), 0.7, epsilon = 1e-15); // J
/// let seen = Screw::<f64, BodyAxes>::between(&start, &end); // the body slides and turns on a circle
/// assert!((seen.moving(&start).position - end.position).norm() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "T: Scalar + serde::Serialize",
        deserialize = "T: Scalar + serde::Deserialize<'de>"
    ))
)]
pub struct Screw<T, F = WorldAxes> {
    /// The part of translation.
    pub translation: Vector3<T>,
    /// The part of rotation.
    pub rotation: Vector3<T>,
    #[cfg_attr(feature = "serde", serde(skip))]
    axes: PhantomData<F>,
}

impl<T: Scalar, F: Axes> Screw<T, F> {
    /// The screw of these parts.
    #[inline(always)]
    pub fn new(translation: Vector3<T>, rotation: Vector3<T>) -> Self {
        Self { translation, rotation, axes: PhantomData }
    }

    /// The wrench about the reference point of a `force` that acts at `arm` from it, `(f, r × f)`.
    #[inline]
    pub fn of_force(force: Vector3<T>, arm: Vector3<T>) -> Self {
        Self::new(force, arm.cross(&force))
    }

    /// Of a twist, the velocity of the body's point at `arm` from the reference point, `v + ω × r`.
    #[inline]
    pub fn velocity_at(&self, arm: Vector3<T>) -> Vector3<T> {
        self.translation + self.rotation.cross(&arm)
    }

    /// The same screw along other axes, for a body in `pose`.
    #[inline]
    pub fn along<G: Axes>(self, pose: &Pose<T>) -> Screw<T, G> {
        let turned = |vector| G::from_world(pose, F::to_world(pose, vector));
        Screw::new(turned(self.translation), turned(self.rotation))
    }
}

impl<T: Angle, F: Axes> Screw<T, F> {
    /// The displacement that leads from one pose to another: the constant twist that does it, times the period.
    ///
    /// ```text
    /// WorldAxes   (p₁ − p₀, log(R₁ R₀ᵀ))
    /// BodyAxes    log(X₀⁻¹ X₁) = (V(φ)⁻¹ R₀ᵀ (p₁ − p₀), φ),   φ = log(R₀ᵀ R₁)
    /// V(φ)⁻¹ x = x − φ × x / 2 + (1 − (θ/2) cot(θ/2)) / θ² φ × (φ × x),   θ = |φ| ≤ π
    /// ```
    ///
    /// A half turn leads to the same orientation either way round; of two quaternions that differ by sign either gives
    /// the same displacement. For quaternions of length 1 the rotation is accurate to `4 ε θ`, from the last bit of the
    /// readings to half a turn; the translation to `ε |p₁ − p₀|` on each axis of the world and to `8 ε |p₁ − p₀|` along
    /// the body's (Murray, Li and Sastry, A Mathematical Introduction to Robotic Manipulation, 1994, appendix A;
    /// `tests/poses/logarithm.rs` holds it against a matrix exponential with thirty digits).
    ///
    /// **Work.** A wrench that is held along these axes over the period did the work `wrench · displacement` exactly
    /// if the twist was constant along them; along the world's axes the force's part is exact for every motion. Else what
    /// is booked differs from the work done by a term of third order in the period, the second one of Magnus' series:
    ///
    /// ```text
    /// WorldAxes   −τ·(ω × ω̇) T³ / 12
    /// BodyAxes    (f·(ω × v̇ + v × ω̇) + τ·(ω × ω̇)) T³ / 12
    /// ```
    ///
    /// With `θ = |ω| T` the rotation of one tick and `δ` the angle by which the axis of rotation turns meanwhile, the
    /// torque's part is at most `|τ| θ² δ / 12` J.
    #[inline]
    pub fn between(from: &Pose<T>, to: &Pose<T>) -> Self {
        F::between(from, to)
    }

    /// The pose to which this displacement leads from another: the inverse of [`between`](Self::between), for
    /// rotations of up to half a turn.
    #[inline]
    pub fn moving(self, from: &Pose<T>) -> Pose<T> {
        F::moving(self, from)
    }
}

impl<T: Scalar, F: Axes> Default for Screw<T, F> {
    /// Nothing: no twist, no wrench.
    #[inline(always)]
    fn default() -> Self {
        Self::zero()
    }
}

crate::signal_of_parts! {
    #[inline(always)]
    impl[T: Scalar, F: Axes] Screw<T, F>, in T, of translation, rotation => Self::new(translation, rotation);
}
