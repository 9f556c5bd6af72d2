//! Angles: the functions that a logarithm of rotations needs.

use crate::Scalar;

/// A scalar whose angles have sines and arc tangents: `f32` and `f64`, one value at a time.
///
/// They come from `libm` in the scalar's own width, so that a pose has the same bits on every machine, with `std` and
/// without. Lanes are left out: no function of `libm` works on them.
///
/// ```
/// use lyapunov_core::Angle;
/// let (sine, cosine) = 0.3_f32.sine_cosine();
/// assert!((sine.arc_tangent(cosine) - 0.3).abs() < 1e-7);
/// ```
pub trait Angle: Scalar<Mask = bool> {
    /// Sine and cosine.
    fn sine_cosine(self) -> (Self, Self);

    /// The angle of the point `(cosine, self)`, rad, from −π to π.
    fn arc_tangent(self, cosine: Self) -> Self;
}

impl Angle for f32 {
    #[inline]
    fn sine_cosine(self) -> (Self, Self) {
        libm::sincosf(self)
    }

    #[inline]
    fn arc_tangent(self, cosine: Self) -> Self {
        libm::atan2f(self, cosine)
    }
}

impl Angle for f64 {
    #[inline]
    fn sine_cosine(self) -> (Self, Self) {
        libm::sincos(self)
    }

    #[inline]
    fn arc_tangent(self, cosine: Self) -> Self {
        libm::atan2(self, cosine)
    }
}
