//! Virtual spring, the paper's example 1.

use lyapunov_core::{ParameterError, Requirement, Scalar, Signal};

use crate::{ForceLaw, Kinematics};

/// A virtual spring, `f = k (x − position)`: the paper's example 1 (equation 9), two-sided.
///
/// ```
/// use lyapunov_core::{OnePort, PortSample};
/// use lyapunov_plants::Spring;
/// use nalgebra::Vector2;
/// let mut spring = Spring::new(500.0)?.at(Vector2::new(0.1, 0.0));
/// let effort = spring.respond(&PortSample::starting(1e-3, Vector2::new(0.1, 0.02), Vector2::zeros()));
/// assert!((effort - Vector2::new(0.0, 10.0)).norm() < 1e-12);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring<V: Signal> {
    stiffness: V::Scalar,
    position: V,
}

impl<V: Signal> Spring<V> {
    /// A spring of `stiffness` N/m, relaxed at the origin.
    ///
    /// # Errors
    /// `stiffness` infinite or NaN; a negative one makes a spring that pushes away.
    pub fn new(stiffness: V::Scalar) -> Result<Self, ParameterError> {
        let stiffness = Requirement::Finite.check("stiffness", stiffness)?;
        Ok(Self { stiffness, position: V::zero() })
    }

    /// The same spring, relaxed at `position`, m.
    #[must_use]
    pub fn at(self, position: V) -> Self {
        Self { position, ..self }
    }

    /// The same spring, stiffer by `stiffness` N/m.
    #[inline]
    pub(super) fn stiffened(self, stiffness: V::Scalar) -> Self {
        Self { stiffness: self.stiffness + stiffness, ..self }
    }
}

impl<V: Signal> ForceLaw<V> for Spring<V> {
    #[inline(always)]
    fn force(&self, motion: &Kinematics<V>) -> V {
        (motion.position - self.position).scale(self.stiffness)
    }

    fn stored(&self, motion: &Kinematics<V>) -> V::Scalar {
        let away = motion.position - self.position;
        V::Scalar::of(0.5) * self.force(motion).inner(away)
    }
}
