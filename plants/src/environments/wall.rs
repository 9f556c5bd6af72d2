//! Wall of the paper's evaluation.

use lyapunov_core::{Dissipation, InContact, ParameterError, Requirement, Scalar};

use crate::environments::one_sided::{depth_stored, one_sided};
use crate::{ForceLaw, Kinematics, Surface, Time};

/// A one-sided virtual wall: `f = max(0, k p + b v)` for a penetration `p = x − position > 0`, else 0.
///
/// The environment of the paper's section IV; that its force never pulls is the usual reading.
///
/// ```
/// use lyapunov_core::{OnePort, PortSample};
/// use lyapunov_plants::Wall;
/// let mut wall = Wall::new(8000.0, 2.0)?.at(0.01); // N/m, N·s/m, m
/// let effort: f64 = wall.respond(&PortSample::starting(1e-3, 0.011, 0.1)); // 1 mm deep
/// assert!((effort - 8.2).abs() < 1e-9);
/// assert_eq!(wall.respond(&PortSample::starting(1e-3, 0.0, 0.1)), 0.0); // in front of it
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wall<T> {
    stiffness: T,
    damper: Dissipation<T>,
    position: T,
}

impl<T: Scalar> Wall<T> {
    /// A wall of `stiffness` N/m and `damping` N·s/m with its surface at the origin.
    ///
    /// # Errors
    /// `stiffness` or `damping` below 0, infinite or NaN.
    pub fn new(stiffness: T, damping: T) -> Result<Self, ParameterError> {
        Ok(Self {
            stiffness: Requirement::NonNegative.check("stiffness", stiffness)?,
            damper: Dissipation::of(damping)?,
            position: T::zero(),
        })
    }

    /// The same wall with its surface at `position`, m.
    #[must_use]
    pub fn at(self, position: T) -> Self {
        Self { position, ..self }
    }

    /// The same wall with its surface `offset` m farther.
    #[inline(always)]
    pub(super) fn shifted(self, offset: T) -> Self {
        Self { position: self.position + offset, ..self }
    }

    /// The credit of the wall's own damper, counted beyond the surface: with [`PortEnergy`](lyapunov_core::PortEnergy)
    /// the candidate of the paper's example 2.
    ///
    /// Contact means strictly beyond the surface at the time of the observer's tick, even while a slower wall's force
    /// is held or clipped to 0. The wall's damper is virtual: under a hold it dissipates less than this credits, and
    /// the observed energy may stay positive on a loop that gains energy.
    pub fn dissipation(&self) -> Dissipation<T, InContact<T>> {
        self.damper.gated(InContact { position: self.position })
    }
}

impl<T: Scalar> ForceLaw<T> for Wall<T> {
    #[inline(always)]
    fn force(&self, motion: &Kinematics<T>) -> T {
        let depth = motion.position - self.position;
        one_sided(depth, self.stiffness * depth + self.damper.damping() * motion.velocity)
    }

    fn stored(&self, motion: &Kinematics<T>) -> T {
        depth_stored(self.stiffness, motion.position - self.position)
    }

    fn surface(&self, _time: Time<T>) -> Option<Surface<T>> {
        Some(Surface { position: self.position, velocity: T::zero() })
    }
}
