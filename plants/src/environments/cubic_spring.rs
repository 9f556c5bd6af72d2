//! Hardening spring.

use lyapunov_core::{ParameterError, Requirement, Scalar, Signal};

use crate::{ForceLaw, Kinematics};

/// A hardening spring, two-sided: `f = (k + c d²) d` for `d = x − position`, on several axes with `d² = d·d`.
///
/// With a mass it is Duffing's oscillator (I. Kovacic and M. J. Brennan, The Duffing Equation, 2011). It stores
/// `k d² / 2 + c d⁴ / 4`, and its stiffness to a small motion about `d` is `k + 3 c d²`: a loop that is stable near the
/// rest may be unstable farther out. With `c = 0` it is a [`Spring`](crate::Spring), to the last bit.
///
/// ```
/// use lyapunov_core::{PortSample, OnePort};
/// use lyapunov_plants::CubicSpring;
/// let mut spring: CubicSpring<f64> = CubicSpring::new(100.0, 1e6)?;
/// let effort = spring.respond(&PortSample::starting(1e-3, 0.01, 0.0));
/// assert!((effort - 2.0).abs() < 1e-12); // 1 N and 1 N
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CubicSpring<V: Signal> {
    stiffness: V::Scalar,
    cubic: V::Scalar,
    position: V,
}

impl<V: Signal> CubicSpring<V> {
    /// A spring of `stiffness` N/m and `cubic` N/m³, relaxed at the origin.
    ///
    /// # Errors
    /// `stiffness` or `cubic` below 0, infinite or NaN: beyond some distance a softening spring pushes away.
    pub fn new(stiffness: V::Scalar, cubic: V::Scalar) -> Result<Self, ParameterError> {
        Ok(Self {
            stiffness: Requirement::NonNegative.check("stiffness", stiffness)?,
            cubic: Requirement::NonNegative.check("cubic", cubic)?,
            position: V::zero(),
        })
    }

    /// The same spring, relaxed at `position`, m.
    #[must_use]
    pub fn at(self, position: V) -> Self {
        Self { position, ..self }
    }
}

impl<V: Signal> ForceLaw<V> for CubicSpring<V> {
    #[inline(always)]
    fn force(&self, motion: &Kinematics<V>) -> V {
        let away = motion.position - self.position;
        away.scale(self.stiffness + self.cubic * away.inner(away))
    }

    fn stored(&self, motion: &Kinematics<V>) -> V::Scalar {
        let away = motion.position - self.position;
        let square = away.inner(away);
        let of = V::Scalar::of;
        of(0.5) * self.stiffness * square + of(0.25) * self.cubic * square * square
    }
}
