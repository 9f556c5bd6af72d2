//! Logarithm and exponential of rotations, by quaternions.
//!
//! A quaternion is `(i, j, k, w)` and need not have length 1: every function here depends on its direction only.

use nalgebra::{Vector3, Vector4};

use crate::{Angle, Pose, Scalar};

/// `θ²` below which the series of a coefficient is used: the terms left out are below the last digit of `f64`.
const SERIES: f64 = 1e-4;

/// Vector part and real part of the quaternion that leads from one orientation to another, the nearer way round.
///
/// The vector part is taken from the difference `d = q₁ − q₀`, which rounds to the digits of the difference: a small
/// rotation keeps its relative accuracy, where the product `q₀* q₁` has lost it. `cross` is `d × q₀` along the body's
/// axes and `q₀ × d` along the world's.
#[inline]
pub(super) fn half_turn<T: Angle>(
    from: &Pose<T>,
    to: &Pose<T>,
    cross: impl Fn(Vector3<T>, Vector3<T>) -> Vector3<T>,
) -> (Vector3<T>, T) {
    let real = from.quaternion.dot(&to.quaternion);
    // A quaternion and its negative are the same orientation.
    let nearer = if real.below(T::of(0.0)) { -to.quaternion } else { to.quaternion };
    let change = nearer - from.quaternion;
    let (own, w) = (from.quaternion.xyz(), from.quaternion.w);
    (change.xyz() * w - own * change.w + cross(change.xyz(), own), real.magnitude())
}

/// The rotation vector `φ` of a quaternion with a real part not below 0, rad, of a length up to π, and the coefficient
/// `(1 − (θ/2) cot(θ/2)) / θ²` of the logarithm of rigid motions.
#[inline]
pub(super) fn rotation_vector<T: Angle>((vector, real): (Vector3<T>, T)) -> (Vector3<T>, T) {
    let (one, two) = (T::of(1.0), T::of(2.0));
    let square = vector.dot(&vector);
    let ratio = if square.below(T::epsilon() * real * real) {
        // atan(x) = x (1 − x²/3 + …); the length of the vector may be too small to be squared.
        two / real * (one - square / (T::of(3.0) * real * real))
    } else {
        let length = square.sqrt();
        two * length.arc_tangent(real) / length
    };
    let rotation = vector * ratio;
    let turned = rotation.dot(&rotation);
    let curl = if turned.below(T::of(SERIES)) {
        T::of(1.0 / 12.0) + turned * T::of(1.0 / 720.0)
    } else {
        (one - ratio * real * T::of(0.5)) / turned
    };
    (rotation, curl)
}

/// A rotation by a rotation vector `φ`.
pub(super) struct Turn<T> {
    /// `(sin(θ/2) φ/θ, cos(θ/2))`.
    pub(super) quaternion: Vector4<T>,
    /// `θ² = φ·φ`.
    square: T,
    /// `sin(θ/2) / θ`.
    ratio: T,
}

impl<T: Angle> Turn<T> {
    #[inline]
    pub(super) fn by(rotation: Vector3<T>) -> Self {
        let half = T::of(0.5);
        let square = rotation.dot(&rotation);
        let angle = square.sqrt();
        let (sine, cosine) = (angle * half).sine_cosine();
        let ratio = if square.below(T::epsilon()) { half } else { sine / angle };
        let vector = rotation * ratio;
        let quaternion = Vector4::new(vector.x, vector.y, vector.z, cosine);
        Self { quaternion, square, ratio }
    }

    /// The coefficients `(1 − cos θ) / θ²` and `(θ − sin θ) / θ³` of the exponential of rigid motions.
    #[inline]
    pub(super) fn coefficients(&self) -> (T, T) {
        let twice = T::of(2.0) * self.ratio;
        let second = if self.square.below(T::of(SERIES)) {
            T::of(1.0 / 6.0) - self.square * T::of(1.0 / 120.0)
        } else {
            (T::of(1.0) - twice * self.quaternion.w) / self.square
        };
        (twice * self.ratio, second)
    }
}

/// The product of two quaternions, of length 1.
#[inline]
pub(super) fn product<T: Scalar>(first: &Vector4<T>, second: &Vector4<T>) -> Vector4<T> {
    let (a, b) = (first.xyz(), second.xyz());
    let vector = b * first.w + a * second.w + a.cross(&b);
    let whole = Vector4::new(vector.x, vector.y, vector.z, first.w * second.w - a.dot(&b));
    let length = whole.dot(&whole).sqrt();
    whole.map(|number| number / length)
}
